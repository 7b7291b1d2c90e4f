#include "protocol/codec.hpp"
#include "protocol/intake/decode_client.hpp"
#include "protocol/limits.hpp"
#include "tests/protocol/random_messages.hpp"

#include <gtest/gtest.h>
#include <variant>

namespace poolhall::protocol {
namespace {

constexpr int kRounds = 200;

class RoundTrip : public ::testing::TestWithParam<Encoding> {};

INSTANTIATE_TEST_SUITE_P(Encodings, RoundTrip, ::testing::Values(Encoding::kJson, Encoding::kCbor),
                         [](const auto& param) {
                             return param.param == Encoding::kJson ? "Json" : "Cbor";
                         });

TEST_P(RoundTrip, ClientMessagesComeBackEqual) {
    testing::Random random(1);
    for (int round = 0; round < kRounds; ++round) {
        const auto messages = testing::random_client_messages(random);
        ASSERT_EQ(messages.size(), std::variant_size_v<ClientBody>);
        for (std::size_t i = 0; i < messages.size(); ++i) {
            ASSERT_EQ(messages[i].body.index(), i) << "the samples follow the list of messages";
            const std::string bytes = encode(messages[i], GetParam());
            ASSERT_LE(bytes.size(), kMaxClientMessageBytes);
            const auto back = decode_client(bytes, GetParam());
            ASSERT_TRUE(back.ok()) << back.error().reason << "\n" << bytes;
            ASSERT_EQ(*back, messages[i]) << bytes;
        }
    }
}

TEST_P(RoundTrip, ServerMessagesComeBackEqual) {
    testing::Random random(2);
    for (int round = 0; round < kRounds; ++round) {
        const auto messages = testing::random_server_messages(random);
        ASSERT_EQ(messages.size(), std::variant_size_v<ServerMessage>);
        for (std::size_t i = 0; i < messages.size(); ++i) {
            ASSERT_EQ(messages[i].index(), i) << "the samples follow the list of messages";
            const std::string bytes = encode(messages[i], GetParam());
            const auto back = decode_server(bytes, GetParam());
            ASSERT_TRUE(back.ok()) << back.error().reason << "\n" << bytes;
            ASSERT_EQ(*back, messages[i]) << bytes;
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
    for (const char* key : {"ruling", "live", "strike", "null"})
        EXPECT_EQ(json.find(key), std::string::npos) << key;
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
