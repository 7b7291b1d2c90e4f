#pragma once

#include "protocol/messages.hpp"

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

// How trees are read: a cursor knows where it stands, so that the first fault can be named by its
// JSON pointer.
namespace poolhall::protocol::wire {

using Json = nlohmann::ordered_json;

enum class UnknownFields : std::uint8_t { kRefuse, kSkip };

/// Whether a number of a scene may also be a string with a C hex-float.
enum class HexFloats : std::uint8_t { kRefuse, kRead };

/// The first thing that was wrong with a tree.
struct ReadError {
    RejectCode code = RejectCode::kBadField;
    std::string pointer;  ///< JSON pointer; empty for the root
    std::string reason;   ///< completes "field <pointer> ...": "must be a number"
};

/// Brings a person's name into the form that is kept; why it cannot, or nothing.
using NameEntry = std::optional<std::string_view> (*)(std::string& name);

/// What the cursors of one reading share.
struct Reading {
    UnknownFields unknown_fields = UnknownFields::kRefuse;
    HexFloats hex_floats = HexFloats::kRead;
    NameEntry enter_name = nullptr;  ///< none where names are read that a server has taken
    std::optional<ReadError> error = {};
};

/// A value in a tree and the way to it. Cursors live on the stack, each within the life of the one
/// it came from; the way is put into words only when something is wrong.
class Cursor {
  public:
    Cursor(const Json& root, Reading& reading) : json_(root), reading_(reading) {}

    [[nodiscard]] const Json& json() const { return json_; }

    [[nodiscard]] bool skips_unknown_fields() const {
        return reading_.unknown_fields == UnknownFields::kSkip;
    }

    [[nodiscard]] bool reads_hex_floats() const { return reading_.hex_floats == HexFloats::kRead; }

    [[nodiscard]] NameEntry name_entry() const { return reading_.enter_name; }

    /// The field of an object, or nullptr.
    [[nodiscard]] const Json* find(std::string_view key) const;
    /// The cursor of a field that find() found.
    [[nodiscard]] Cursor field(std::string_view key, const Json& value) const;
    /// The cursor of another tree in the place of this one.
    [[nodiscard]] Cursor in_place(const Json& json) const;
    /// The cursor of an array's element.
    [[nodiscard]] Cursor element(std::size_t index) const;

    /// Records what is wrong here, and is false so that a reader can return it.
    [[nodiscard]] bool refuse(std::string reason) const;
    /// The same for a place below this one.
    [[nodiscard]] bool refuse_at(std::string_view pointer_below, std::string reason,
                                 RejectCode code = RejectCode::kBadField) const;
    [[nodiscard]] bool refuse_missing(std::string_view key) const;
    [[nodiscard]] bool refuse_unknown(std::string_view key) const;

  private:
    Cursor(const Json& json, const Cursor& parent, std::string_view key, std::size_t index)
        : json_(json), reading_(parent.reading_), parent_(&parent), key_(key), index_(index) {}

    Cursor(const Json& json, const Cursor& replaced)
        : json_(json),
          reading_(replaced.reading_),
          parent_(replaced.parent_),
          key_(replaced.key_),
          index_(replaced.index_) {}

    [[nodiscard]] std::string pointer() const;

    const Json& json_;
    Reading& reading_;
    const Cursor* parent_ = nullptr;
    std::string_view key_;   ///< in the parent, where that is an object
    std::size_t index_ = 0;  ///< in the parent, where that is an array
};

/// A key as a step of a JSON pointer (RFC 6901), leading slash included.
[[nodiscard]] std::string pointer_step(std::string_view key);

}  // namespace poolhall::protocol::wire
