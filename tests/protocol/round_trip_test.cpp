#include "protocol/codec/codec.hpp"
#include "protocol/intake/decode_client.hpp"
#include "protocol/limits.hpp"
#include "tests/protocol/random_messages.hpp"
#include "tests/protocol/types.hpp"

#include <gtest/gtest.h>
#include <string>
#include <variant>
#include <vector>

namespace poolhall::protocol {
namespace {

constexpr int kRounds = 200;

class RoundTrip : public ::testing::TestWithParam<Encoding> {};

INSTANTIATE_TEST_SUITE_P(Encodings, RoundTrip, ::testing::Values(Encoding::kJson, Encoding::kCbor),
                         [](const auto& param) {
                             return param.param == Encoding::kJson ? "Json" : "Cbor";
                         });

/// The types of the messages, each once, in their order.
template <class Messages, class TypeOf>
std::vector<std::string> types_in(const Messages& messages, TypeOf type_of) {
    std::vector<std::string> types;
    for (const auto& message : messages) {
        const std::string type(type_of(message));
        if (types.empty() || types.back() != type) types.push_back(type);
    }
    return types;
}

TEST(RandomMessages, AreOfEveryKindAndOfEveryMove) {
    testing::Random random(1);
    const auto messages = testing::random_client_messages(random);
    EXPECT_EQ(types_in(messages, [](const auto& each) { return wire::type_of(each.body); }),
              testing::types_of<ClientBody>());
    EXPECT_EQ(types_in(testing::random_server_messages(random),
                       [](const auto& each) { return wire::type_of(each); }),
              testing::types_of<ServerMessage>());
    EXPECT_EQ(types_in(testing::random_moves(random),
                       [](const auto& each) { return wire::type_of(each); }),
              testing::types_of<Move>());
}

TEST_P(RoundTrip, ClientMessagesComeBackEqual) {
    testing::Random random(1);
    for (int round = 0; round < kRounds; ++round) {
        const auto messages = testing::random_client_messages(random);
        for (const ClientMessage& message : messages) {
            const std::string bytes = encode(message, GetParam());
            ASSERT_LE(bytes.size(), kMaxClientMessageBytes);
            const auto back = decode_client(bytes, GetParam());
            ASSERT_TRUE(back.ok()) << back.error().reason << "\n" << bytes;
            ASSERT_EQ(*back, message) << bytes;
        }
    }
}

TEST_P(RoundTrip, ServerMessagesComeBackEqual) {
    testing::Random random(2);
    for (int round = 0; round < kRounds; ++round) {
        const auto messages = testing::random_server_messages(random);
        for (const ServerMessage& message : messages) {
            const std::string bytes = encode(message, GetParam());
            const auto back = decode_server(bytes, GetParam());
            ASSERT_TRUE(back.ok()) << back.error().reason << "\n" << bytes;
            ASSERT_EQ(*back, message) << bytes;
        }
    }
}

/// No message is a prefix of another, so every cut must be noticed.
TEST_P(RoundTrip, TruncationAtEveryByteIsRefused) {
    testing::Random random(3);
    for (const ClientMessage& message : testing::random_client_messages(random)) {
        const std::string bytes = encode(message, GetParam());
        for (std::size_t length = 0; length < bytes.size(); ++length) {
            const auto cut = decode_client(bytes.substr(0, length), GetParam());
            ASSERT_FALSE(cut.ok()) << length;
            ASSERT_EQ(cut.error().code, RejectCode::kMalformed);
        }
    }
    for (const ServerMessage& message : testing::random_server_messages(random)) {
        const std::string bytes = encode(message, GetParam());
        for (std::size_t length = 0; length < bytes.size(); ++length)
            ASSERT_FALSE(decode_server(bytes.substr(0, length), GetParam()).ok()) << length;
    }
}

TEST_P(RoundTrip, TrailingBytesAreRefused) {
    testing::Random random(4);
    for (const ClientMessage& message : testing::random_client_messages(random)) {
        const auto result = decode_client(encode(message, GetParam()) + "0", GetParam());
        ASSERT_FALSE(result.ok());
        EXPECT_EQ(result.error().code, RejectCode::kMalformed);
    }
}

TEST(FrameEncoding, RoundsPositionsForDisplay) {
    Frame frame;
    frame.balls = {{BallIndex{0}, {0.123456789, -0.1}}};
    const std::string json = encode(frame, Encoding::kJson);
    EXPECT_NE(json.find("[0,0.12346,-0.1]"), std::string::npos) << json;

    const auto back = decode_server(encode(frame, Encoding::kCbor), Encoding::kCbor);
    ASSERT_TRUE(back.ok());
    EXPECT_EQ(std::get<Frame>(*back).balls[0].r.x, static_cast<double>(0.123456789F));
}

TEST(FrameEncoding, TakesFiveBytesANumberInCbor) {
    Frame frame;
    const std::size_t empty = encode(frame, Encoding::kCbor).size();
    frame.balls = {{BallIndex{0}, {0.123456789, -0.987654321}}};
    EXPECT_EQ(encode(frame, Encoding::kCbor).size() - empty, 1 + 1 + 5 + 5U);
}

TEST(OptionalMembers, AreAbsentWhenNotSet) {
    TableChanged changed;
    changed.table.match = "m";
    const std::string json = encode(changed, Encoding::kJson);
    for (const char* key : {"settings", "ruling", "live", "strike", "winner", "clock_left_ms",
                            "\"cue\"", "place", "shoot", "null"})
        EXPECT_EQ(json.find(key), std::string::npos) << key;
    const std::string shot =
        encode(ClientMessage{1, TurnCommand{MakeMove{{}, Shoot{}}}}, Encoding::kJson);
    EXPECT_EQ(shot.find("speed"), std::string::npos) << "left to the game";
}

TEST(Encoding, TypeComesFirst) {
    EXPECT_EQ(encode(ClientMessage{7, Ping{}}, Encoding::kJson), R"({"type":"ping","seq":7})");
    EXPECT_EQ(encode(Accepted{7}, Encoding::kJson), R"({"type":"accepted","seq":7})");
}

TEST(Encoding, BadUtf8DoesNotThrow) {
    const std::string json = encode(Closing{"\xFF\xFE"}, Encoding::kJson);
    EXPECT_TRUE(decode_server(json, Encoding::kJson).ok());
}

TEST(Subprotocols, AreKnownByName) {
    EXPECT_EQ(encoding_of("poolhall.v1.json"), Encoding::kJson);
    EXPECT_EQ(encoding_of("poolhall.v1.cbor"), Encoding::kCbor);
    EXPECT_EQ(encoding_of("poolhall.v2.json"), std::nullopt);
    EXPECT_EQ(encoding_of(""), std::nullopt);
}

}  // namespace
}  // namespace poolhall::protocol
