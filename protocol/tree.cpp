#include "protocol/tree.hpp"

#include "protocol/cbor_guard.hpp"
#include "protocol/limits.hpp"
#include "protocol/text.hpp"

#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

namespace poolhall::protocol {
namespace {

using Json = nlohmann::ordered_json;

/// More than any object of ours has. Looking for a key twice takes time with the square of their
/// number.
constexpr std::size_t kMaxKeys = 64;

/// Builds a tree from a parser's events and stops the parser at the first thing that is not
/// allowed.
class Builder final : public nlohmann::json_sax<Json> {
  public:
    // NOLINTNEXTLINE(bugprone-exception-escape): a null tree throws nothing
    Builder() = default;
    Builder(const Builder&) = delete;  // open_ points into tree
    Builder& operator=(const Builder&) = delete;

    bool null() override { return add(nullptr); }

    bool boolean(bool value) override { return add(value); }

    bool number_integer(number_integer_t value) override { return add(value); }

    bool number_unsigned(number_unsigned_t value) override { return add(value); }

    bool number_float(number_float_t value, const string_t& /*text*/) override {
        return add(value);
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
                     const nlohmann::json::exception& /*what*/) override {
        error.position = position;
        return refuse("a syntax error at byte " + std::to_string(position));
    }

    Json tree;
    TreeError error;

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

    std::vector<Json*> open_;
    std::string key_;
};

}  // namespace

Result<Json, TreeError> parse_tree(std::string_view bytes, Encoding encoding) {
    const bool cbor = encoding == Encoding::kCbor;
    if (cbor) {
        if (auto fault = find_cbor_fault(bytes)) return TreeError{*std::move(fault)};
    }
    Builder builder;
    const auto format = cbor ? Json::input_format_t::cbor : Json::input_format_t::json;
    if (!Json::sax_parse(bytes.begin(), bytes.end(), &builder, format)) {
        return std::move(builder.error);
    }
    return std::move(builder.tree);
}

std::string write_tree(const Json& tree, Encoding encoding) {
    if (encoding == Encoding::kJson)
        return tree.dump(-1, ' ', false, Json::error_handler_t::replace);
    std::string bytes;
    Json::to_cbor(tree, bytes);
    return bytes;
}

}  // namespace poolhall::protocol
