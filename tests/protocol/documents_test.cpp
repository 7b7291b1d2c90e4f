#include "protocol/codec.hpp"
#include "protocol/intake/decode_client.hpp"
#include "protocol/limits.hpp"
#include "protocol/wire/enums.hpp"

#include <fstream>
#include <gtest/gtest.h>
#include <set>
#include <sstream>
#include <string>
#include <type_traits>
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

template <class... Bodies>
std::set<std::string> types_of(std::type_identity<std::variant<Bodies...>> /*list*/) {
    return {std::string(Bodies::kType)...};
}

template <class... Bodies>
std::string type_of(const std::variant<Bodies...>& body) {
    return std::visit([](const auto& alternative) { return std::string(alternative.kType); }, body);
}

TEST(ProtocolPage, HasAGoodExampleOfEachClientMessage) {
    std::set<std::string> seen;
    for (const std::string& example : examples("client")) {
        const auto message = decode_client(example, Encoding::kJson);
        ASSERT_TRUE(message.ok()) << message.error().reason << "\n" << example;
        seen.insert(type_of(message->body));
    }
    EXPECT_EQ(seen, types_of(std::type_identity<ClientBody>{}));
}

TEST(ProtocolPage, HasAGoodExampleOfEachServerMessage) {
    std::set<std::string> seen;
    for (const std::string& example : examples("server")) {
        const auto message = decode_server(example, Encoding::kJson);
        ASSERT_TRUE(message.ok()) << message.error().reason << "\n" << example;
        seen.insert(type_of(*message));
    }
    EXPECT_EQ(seen, types_of(std::type_identity<ServerMessage>{}));
}

template <class E>
void expect_names(const std::string& text) {
    for (unsigned i = 0; i <= static_cast<unsigned>(wire::kLast<E>); ++i) {
        using wire::name;
        const std::string quoted = "`" + std::string(name(static_cast<E>(i))) + "`";
        EXPECT_NE(text.find(quoted), std::string::npos) << quoted;
    }
}

TEST(ProtocolPage, NamesEveryEnumerator) {
    const std::string text = page();
    expect_names<RejectCode>(text);
    expect_names<Phase>(text);
    expect_names<Stream>(text);
    expect_names<Verdict>(text);
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
          std::string(kSubprotocolCbor)}) {
        EXPECT_NE(text.find(limit), std::string::npos) << limit;
    }
}

}  // namespace
}  // namespace poolhall::protocol
