#pragma once

#include "shared/enum_names.hpp"

#include <cstdint>
#include <optional>
#include <string_view>

namespace poolhall::protocol {

enum class Encoding : std::uint8_t {
    kJson,  ///< WebSocket text frames
    kCbor,  ///< WebSocket binary frames
};

constexpr auto enum_names(Encoding /*type*/) {
    return names_of<Encoding>({{Encoding::kJson, "json"}, {Encoding::kCbor, "cbor"}});
}

/// The encoding of a WebSocket subprotocol's name, if it is one of ours.
[[nodiscard]] std::optional<Encoding> encoding_of(std::string_view subprotocol);

}  // namespace poolhall::protocol
