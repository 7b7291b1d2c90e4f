#include "protocol/names.hpp"

#include "protocol/encoding.hpp"
#include "protocol/limits.hpp"

namespace poolhall::protocol {

std::optional<Encoding> encoding_of(std::string_view subprotocol) {
    if (subprotocol == kSubprotocolJson) return Encoding::kJson;
    if (subprotocol == kSubprotocolCbor) return Encoding::kCbor;
    return std::nullopt;
}

std::string_view name(Phase phase) {
    return poolhall::name(phase);
}

std::string_view name(RejectCode code) {
    return poolhall::name(code);
}

std::string_view name(Stream stream) {
    return poolhall::name(stream);
}

}  // namespace poolhall::protocol
