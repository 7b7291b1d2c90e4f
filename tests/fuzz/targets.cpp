#include "tests/fuzz/targets.hpp"

#include "protocol/codec/codec.hpp"
#include "protocol/codec/scene_json.hpp"
#include "protocol/intake/decode_client.hpp"
#include "protocol/tree.hpp"

#include <cstdlib>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>

namespace poolhall::fuzz {
namespace {

using namespace protocol;

template <class Message, class Decode>
void check_message(std::string_view bytes, Encoding encoding, Decode decode) {
    const Result<Message, DecodeError> first = decode(bytes, encoding);
    if (!first) return require(!first.error().reason.empty(), "refused without a reason");
    // Not compared as values: a frame's positions are rounded when they are written.
    const std::string written = encode(*first, encoding);
    const Result<Message, DecodeError> second = decode(written, encoding);
    require(second.ok(), "refused what was written");
    require(encode(*second, encoding) == written, "changed when it was written and read");
}

}  // namespace

void require(bool holds, const char* what) {
    if (holds) return;
    std::cerr << "fuzz: " << what << "\n";
    std::abort();
}

void client_json(std::string_view bytes) {
    check_message<ClientMessage>(bytes, Encoding::kJson, decode_client);
}

void client_cbor(std::string_view bytes) {
    check_message<ClientMessage>(bytes, Encoding::kCbor, decode_client);
}

void server_json(std::string_view bytes) {
    check_message<ServerMessage>(bytes, Encoding::kJson, decode_server);
}

void server_cbor(std::string_view bytes) {
    check_message<ServerMessage>(bytes, Encoding::kCbor, decode_server);
}

void scene(std::string_view bytes) {
    const auto tree = parse_tree(bytes, Encoding::kJson);
    if (!tree) return;
    const auto first = scene_from_json(*tree);
    if (!first) return require(!first.error().reason.empty(), "refused without a reason");
    const auto second = scene_from_json(to_json(*first));
    require(second.ok(), "refused a scene that was written");
    require(*second == *first, "a scene changed when it was written and read");
}

}  // namespace poolhall::fuzz
