#include "protocol/encoding.hpp"

#include "protocol/limits.hpp"

namespace poolhall::protocol {

std::optional<Encoding> encoding_of(std::string_view subprotocol) {
    if (subprotocol == kSubprotocolJson) return Encoding::kJson;
    if (subprotocol == kSubprotocolCbor) return Encoding::kCbor;
    return std::nullopt;
}

}  // namespace poolhall::protocol
