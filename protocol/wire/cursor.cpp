#include "protocol/wire/cursor.hpp"

#include "protocol/text.hpp"

#include <utility>

namespace poolhall::protocol::wire {

const Json* Cursor::find(std::string_view key) const {
    const auto found = json_.find(key);
    return found == json_.end() ? nullptr : &*found;
}

Cursor Cursor::field(std::string_view key, const Json& value) const {
    return {value, *this, key, 0};
}

Cursor Cursor::in_place(const Json& json) const {
    return {json, *this};
}

Cursor Cursor::element(std::size_t index) const {
    return {json_[index], *this, {}, index};
}

bool Cursor::refuse(std::string reason) const {
    return refuse_at("", std::move(reason));
}

bool Cursor::refuse_at(std::string_view pointer_below, std::string reason, RejectCode code) const {
    reading_.error = ReadError{code, pointer().append(pointer_below), std::move(reason)};
    return false;
}

bool Cursor::refuse_missing(std::string_view key) const {
    return refuse_at(pointer_step(key), "is missing", RejectCode::kMissingField);
}

bool Cursor::refuse_unknown(std::string_view key) const {
    return refuse_at(pointer_step(shown(key)), "is not known", RejectCode::kUnknownField);
}

std::string Cursor::pointer() const {
    if (parent_ == nullptr) return {};
    return parent_->pointer() +
           (parent_->json_.is_array() ? "/" + std::to_string(index_) : pointer_step(key_));
}

std::string pointer_step(std::string_view key) {
    std::string step = "/";
    for (const char c : key) {
        if (c == '~') {
            step += "~0";
        } else if (c == '/') {
            step += "~1";
        } else {
            step += c;
        }
    }
    return step;
}

}  // namespace poolhall::protocol::wire
