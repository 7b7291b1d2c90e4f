#include "protocol/codec/codec.hpp"
#include "protocol/limits.hpp"
#include "tests/protocol/random_messages.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>

// The deepest and the longest messages that there can be are within the limits of the page.
namespace poolhall::protocol {
namespace {

using Json = nlohmann::ordered_json;

std::size_t depth_of(const Json& tree) {
    if (!tree.is_structured()) return 0;
    std::size_t deepest = 0;
    for (const Json& child : tree)
        deepest = std::max(deepest, depth_of(child));
    return 1 + deepest;
}

template <class Message>
std::size_t depth_of_message(const Message& message) {
    return depth_of(Json::parse(encode(message, Encoding::kJson)));
}

TEST(DeepestMessages, FitTheLimitOfNesting) {
    testing::Random random(9);
    std::size_t client = 0;
    std::size_t server = 0;
    for (int round = 0; round < 200; ++round) {
        for (const ClientMessage& message : testing::random_client_messages(random))
            client = std::max(client, depth_of_message(message));
        for (const ServerMessage& message : testing::random_server_messages(random))
            server = std::max(server, depth_of_message(message));
    }
    EXPECT_LE(client, kMaxNesting);
    EXPECT_LE(server, kMaxNesting);
    EXPECT_EQ(server, 7U) << "a coefficient of friction by speed, in the state of a table";
}

/// A number that takes as many bytes as any.
constexpr double kLong = -1.2345678901234567e-100;
constexpr Vec3 kLongVector{kLong, kLong, kLong};

/// As many balls as a scene may have, each with all that a ball can have, and no two touching.
Scene largest_scene() {
    Scene scene;
    scene.table = {1000, 1000, false, PocketModel::kNone, {}};
    scene.effects.rolling = RollingSpec{};
    scene.solver.kind = SolverKind::kEvent;
    for (std::size_t i = 0; i < kMaxBalls; ++i) {
        const std::string number = std::to_string(i);
        const double x = 0.1234567890123 + 0.1 * static_cast<double>(i);
        scene.balls.push_back({number + std::string(64 - number.size(), 'x'),
                               {{x, kLong, 0}, {kLong, kLong, 0}, kLongVector},
                               0.028575123456789012,
                               0.17009712345678901});
    }
    return scene;
}

TEST(LongestMessages, OfTheLargestTableAreBelowWhatAClientMustTake) {
    ShotEnded ended;
    ended.kernel = "rolling";
    ended.effects.assign(64, {std::string(64, 'e'), Bound::kOutOfReach, false});
    ended.table.match = "m";
    ended.table.code = "BCDFGH";
    ended.table.game = "end_game";
    ended.table.state.scene = largest_scene();
    ended.balls.assign(kMaxBalls,
                       FinalBall{Motion::kStationary, {}, {kLongVector, kLongVector, kLongVector}});
    for (const Encoding encoding : {Encoding::kJson, Encoding::kCbor}) {
        const std::string bytes = encode(ServerMessage{ended}, encoding);
        EXPECT_LT(bytes.size(), kMaxServerMessageBytes);
        const auto back = decode_server(bytes, encoding);
        EXPECT_TRUE(back.ok()) << back.error().reason;
    }
}

}  // namespace
}  // namespace poolhall::protocol
