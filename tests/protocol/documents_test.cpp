#include "protocol/codec/codec.hpp"
#include "protocol/intake/decode_client.hpp"
#include "protocol/limits.hpp"
#include "protocol/messages.hpp"
#include "tests/protocol/types.hpp"

#include <fstream>
#include <gtest/gtest.h>
#include <set>
#include <sstream>
#include <string>
#include <variant>
#include <vector>

namespace poolhall::protocol {
namespace {

std::string page() {
    std::ifstream file(POOLHALL_SOURCE_DIR "/protocol/PROTOCOL.md");
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

/// The blocks that are fenced as ```json WHO.
std::vector<std::string> examples(const std::string& who) {
    std::istringstream lines(page());
    std::vector<std::string> blocks;
    bool inside = false;
    for (std::string line; std::getline(lines, line);) {
        if (line == "```json " + who) {
            inside = true;
            blocks.emplace_back();
        } else if (line == "```") {
            inside = false;
        } else if (inside) {
            blocks.back() += line + "\n";
        }
    }
    return blocks;
}

template <class Variant>
std::set<std::string> all_types() {
    const auto types = testing::types_of<Variant>();
    return {types.begin(), types.end()};
}

TEST(ProtocolPage, HasAGoodExampleOfEachClientMessageAndMove) {
    std::set<std::string> seen;
    std::set<std::string> moves;
    for (const std::string& example : examples("client")) {
        const auto message = decode_client(example, Encoding::kJson);
        ASSERT_TRUE(message.ok()) << message.error().reason << "\n" << example;
        seen.emplace(wire::type_of(message->body));
        if (const auto* command = std::get_if<TurnCommand>(&message->body))
            moves.emplace(wire::type_of(std::get<MakeMove>(*command).move));
    }
    EXPECT_EQ(seen, all_types<ClientBody>());
    std::set<std::string> of_players = all_types<Move>();
    of_players.erase("time_out");
    EXPECT_EQ(moves, of_players) << "all that a client may send";
}

TEST(ProtocolPage, HasAGoodExampleOfEachServerMessage) {
    std::set<std::string> seen;
    for (const std::string& example : examples("server")) {
        const auto message = decode_server(example, Encoding::kJson);
        ASSERT_TRUE(message.ok()) << message.error().reason << "\n" << example;
        seen.emplace(wire::type_of(*message));
    }
    EXPECT_EQ(seen, all_types<ServerMessage>());
}

template <class E>
void expect_names(const std::string& text) {
    for (const E value : kValues<E>) {
        const std::string quoted = "`" + std::string(poolhall::name(value)) + "`";
        EXPECT_NE(text.find(quoted), std::string::npos) << quoted;
    }
}

TEST(ProtocolPage, NamesEveryEnumerator) {
    const std::string text = page();
    expect_names<RejectCode>(text);
    expect_names<Phase>(text);
    expect_names<Stream>(text);
    expect_names<Verdict>(text);
    expect_names<Accord>(text);
    expect_names<BreakOrder>(text);
    expect_names<Turns>(text);
    expect_names<EventKind>(text);
    expect_names<Outcome>(text);
    expect_names<Motion>(text);
    expect_names<Rail>(text);
    expect_names<Pocket>(text);
}

TEST(ProtocolPage, StatesTheLimits) {
    const std::string text = page();
    for (const std::string& limit :
         {std::to_string(kMaxClientMessageBytes) + " bytes", std::string(kCodeAlphabet),
          std::to_string(kMaxNameBytes) + " bytes", std::to_string(kTokenHexDigits) + " ",
          std::to_string(kMaxServerMessageBytes) + " bytes", std::string(kSubprotocolJson),
          std::string(kSubprotocolCbor), "at most " + std::to_string(kMaxRace),
          "from " + std::to_string(kMinShotClock) + " to " + std::to_string(kMaxShotClock)}) {
        EXPECT_NE(text.find(limit), std::string::npos) << limit;
    }
}

}  // namespace
}  // namespace poolhall::protocol
