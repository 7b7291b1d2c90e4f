#include "protocol/tree.hpp"

#include "protocol/cbor_guard.hpp"
#include "protocol/limits.hpp"
#include "protocol/overflow.hpp"
#include "protocol/text.hpp"

#include <array>
#include <charconv>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

namespace poolhall::protocol {
namespace {

using Json = nlohmann::ordered_json;

/// More than any object of ours has. Looking for a key twice takes time with the square of their
/// number.
constexpr std::size_t kMaxKeys = 64;

constexpr double kTwoTo64 = 18446744073709551616.0;

Json lost_number() {
    return Json::value_t::discarded;
}

/// A CBOR integer below -2^63: nlohmann's reader takes it modulo 2^64, by which `wrapped` is not
/// negative.
Json far_negative(std::int64_t wrapped) {
    const std::uint64_t magnitude = std::uint64_t{0} - static_cast<std::uint64_t>(wrapped);
    if (magnitude == 0) return -kTwoTo64;
    const auto rounded = static_cast<double>(magnitude);
    const bool exact = rounded < kTwoTo64 && static_cast<std::uint64_t>(rounded) == magnitude;
    return exact ? Json(-rounded) : lost_number();
}

/// False for a JSON integer that is not what the double came to; a fraction is always rounded.
bool is_exact(double value, std::string_view text) {
    const bool integer = text.find_first_not_of("-0123456789") == std::string_view::npos;
    if (!integer || text.empty()) return true;  // CBOR's floats have no text
    std::array<char, 400> digits{};             // the largest double has 309
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                   std::chars_format::fixed, 0);
    return text == std::string_view(digits.data(), end.ptr);
}

/// Builds a tree from a parser's events and stops the parser at the first thing that is not
/// allowed.
class Builder final : public nlohmann::json_sax<Json> {
  public:
    /// `lost`: for each null, in order, whether it stands for a number beyond the largest double.
    explicit Builder(Encoding encoding, std::vector<bool> lost = {})
        : cbor_(encoding == Encoding::kCbor), lost_(std::move(lost)) {}

    Builder(const Builder&) = delete;  // open_ points into tree
    Builder& operator=(const Builder&) = delete;

    bool null() override {
        const bool lost = nulls_ < lost_.size() && lost_[nulls_];
        ++nulls_;
        return add(lost ? lost_number() : Json(nullptr));
    }

    bool boolean(bool value) override { return add(value); }

    /// Below 0, but for the -0 of JSON and what CBOR has below -2^63.
    bool number_integer(number_integer_t value) override {
        return add(value > 0 || (value == 0 && cbor_) ? far_negative(value) : Json(value));
    }

    bool number_unsigned(number_unsigned_t value) override { return add(value); }

    bool number_float(number_float_t value, const string_t& text) override {
        return add(is_exact(value, text) ? Json(value) : lost_number());
    }

    bool string(string_t& value) override {
        return is_utf8(value) ? add(std::move(value)) : refuse("text that is not UTF-8");
    }

    bool binary(binary_t& /*value*/) override { return refuse("a byte string"); }

    bool start_object(std::size_t /*count*/) override { return open(Json::object()); }

    bool start_array(std::size_t /*count*/) override { return open(Json::array()); }

    bool end_object() override { return close(); }

    bool end_array() override { return close(); }

    bool key(string_t& key) override {
        if (!is_utf8(key)) return refuse("a key that is not UTF-8");
        if (open_.back()->size() == kMaxKeys) return refuse("too many keys in one object");
        if (open_.back()->contains(key))
            return refuse("the key " + shown(key) + " twice in one object");
        key_ = std::move(key);
        return true;
    }

    bool parse_error(std::size_t position, const std::string& /*token*/,
                     const nlohmann::json::exception& what) override {
        overflow = what.id == kNumberOverflow;
        error.position = position;
        return refuse("a syntax error at byte " + std::to_string(position));
    }

    Json tree;
    TreeError error;
    bool overflow = false;  ///< the error is a number beyond the largest double

  private:
    bool refuse(std::string why) {
        error.reason = std::move(why);
        return false;
    }

    bool add(Json value) {
        place(std::move(value));
        return true;
    }

    bool open(Json container) {
        if (open_.size() == kMaxNesting) return refuse("arrays or objects nested too deeply");
        open_.push_back(&place(std::move(container)));
        return true;
    }

    bool close() {
        open_.pop_back();
        return true;
    }

    /// Only the innermost container ever grows, so the pointers in open_ stay good.
    Json& place(Json value) {
        if (open_.empty()) return tree = std::move(value);
        Json& parent = *open_.back();
        if (parent.is_object()) return parent[key_] = std::move(value);
        parent.push_back(std::move(value));
        return parent.back();
    }

    bool cbor_;
    std::vector<bool> lost_;
    std::size_t nulls_ = 0;
    std::vector<Json*> open_;
    std::string key_;
};

}  // namespace

Result<Json, TreeError> parse_tree(std::string_view bytes, Encoding encoding) {
    const bool cbor = encoding == Encoding::kCbor;
    if (cbor) {
        if (auto fault = find_cbor_fault(bytes)) return TreeError{*std::move(fault)};
    }
    const auto format = cbor ? Json::input_format_t::cbor : Json::input_format_t::json;
    Builder builder(encoding);
    if (Json::sax_parse(bytes.begin(), bytes.end(), &builder, format))
        return std::move(builder.tree);
    if (!builder.overflow) return std::move(builder.error);
    // The parser gives up at such a number, and what follows may name the message's seq.
    Restated restated = restate(bytes);
    Builder second(encoding, std::move(restated.lost));
    if (Json::sax_parse(restated.text, &second)) return std::move(second.tree);
    return std::move(second.error);
}

std::string write_tree(const Json& tree, Encoding encoding) {
    if (encoding == Encoding::kJson)
        return tree.dump(-1, ' ', false, Json::error_handler_t::replace);
    std::string bytes;
    Json::to_cbor(tree, bytes);
    return bytes;
}

}  // namespace poolhall::protocol
