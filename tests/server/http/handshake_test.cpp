#include "server/http/handshake.hpp"

#include <gtest/gtest.h>

namespace poolhall::server {
namespace {

using protocol::Encoding;

Handshake plain() {
    return {"/ws", "pool.example:8080", {}, {}};
}

/// The HTTP status of the answer; 101 if it is accepted.
int status(const Handshake& handshake, const std::vector<std::string>& allowed = {}) {
    const auto verdict = judge(handshake, allowed);
    const auto* refused = std::get_if<HttpReply>(&verdict);
    return refused ? refused->status : 101;
}

TEST(Handshake, WithoutASubprotocolTheSessionSpeaksJson) {
    const auto verdict = judge(plain(), {});
    EXPECT_EQ(std::get<AcceptedHandshake>(verdict).encoding, Encoding::kJson);
    EXPECT_EQ(std::get<AcceptedHandshake>(verdict).subprotocol, "");
}

TEST(Handshake, FirstKnownSubprotocolOfTheListIsTaken) {
    Handshake handshake = plain();
    handshake.subprotocols = "chat, poolhall.v1.cbor ,poolhall.v1.json";
    const auto verdict = judge(handshake, {});
    EXPECT_EQ(std::get<AcceptedHandshake>(verdict).encoding, Encoding::kCbor);
    EXPECT_EQ(std::get<AcceptedHandshake>(verdict).subprotocol, "poolhall.v1.cbor");
}

TEST(Handshake, UnknownSubprotocolIsToldWhatIsOffered) {
    Handshake handshake = plain();
    handshake.subprotocols = "poolhall.v2.json, ,";
    const auto verdict = judge(handshake, {});
    const HttpReply& reply = std::get<HttpReply>(verdict);
    EXPECT_EQ(reply.status, 400);
    EXPECT_NE(reply.body.find("poolhall.v1.json"), std::string::npos);
    EXPECT_NE(reply.body.find("poolhall.v1.cbor"), std::string::npos);
}

TEST(Handshake, OtherPathIsNotFound) {
    Handshake handshake = plain();
    handshake.target = "/socket";
    EXPECT_EQ(status(handshake), 404);
    handshake.target = "/ws?from=test";
    EXPECT_EQ(status(handshake), 101);
}

TEST(Handshake, PageOfAnotherHostMayNotConnect) {
    Handshake handshake = plain();
    handshake.origin = "http://pool.example:8080";
    EXPECT_EQ(status(handshake), 101);
    handshake.origin = "https://POOL.example:8080";
    EXPECT_EQ(status(handshake), 101);
    for (const char* foreign : {"http://evil.example", "http://pool.example:8081", "null", "",
                                "http://pool.example:8080.evil.example"}) {
        handshake.origin = foreign;
        EXPECT_EQ(status(handshake), 403) << foreign;
    }
}

TEST(Handshake, AllowedOriginsReplaceTheRule) {
    Handshake handshake = plain();
    handshake.origin = "https://club.example";
    EXPECT_EQ(status(handshake, {"https://club.example"}), 101);
    EXPECT_EQ(status(handshake, {"https://other.example"}), 403);
    EXPECT_EQ(status(handshake, {"*"}), 101);
    handshake.origin = "http://pool.example:8080";
    EXPECT_EQ(status(handshake, {"https://club.example"}), 403);
}

}  // namespace
}  // namespace poolhall::server
