#include "client/files/output_file.hpp"
#include "protocol/intake/decode_client.hpp"
#include "protocol/replay/reader.hpp"
#include "tests/server/support/table.hpp"

#include <fstream>
#include <sstream>

// Faults that reports about other programs found here, one test each: what comes in, and what goes
// out into files. What is tried here is the instance; the tests of each module have the kind.
namespace poolhall {
namespace {

using namespace std::string_literals;
using protocol::Encoding;
using server::test::exchange;
using server::test::RunningServer;

/// "ok", or the reject code.
std::string answer_to(const std::string& bytes, Encoding encoding) {
    const auto message = protocol::decode_client(bytes, encoding);
    return message ? "ok" : std::string(name(message.error().code));
}

// nlohmann/json, pull request 5039: CBOR integers below -2^63 wrap round.
TEST(Intake, ACborIntegerBelowMinus2To63IsNoDirection) {
    const std::string aim =
        "\xA4\x64type\x63"s
        "aim\x63seq\x01\x64seat\x00\x69"s
        "direction\x82\x3B\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xFA\x00"s;
    EXPECT_EQ(answer_to(aim, Encoding::kCbor), "bad_field");
}

// garrysmod-issues 5908: names that nobody can see, or that look like another's.
TEST(Intake, NamesThatNobodyCanSeeAreRefused) {
    for (const char* name : {"\u3164", "\u00AD", "\u0301", "\U000E0041", "\uFE0F"})
        EXPECT_EQ(answer_to(R"({"type":"create_match","seq":1,"name":")"s + name + R"("})",
                            Encoding::kJson),
                  "bad_field");
}

TEST(Intake, ANameWithABlankBehindItIsTheSameName) {
    const auto message = protocol::decode_client(R"({"type":"create_match","seq":1,"name":"Ann "})",
                                                 Encoding::kJson);
    ASSERT_TRUE(message);
    EXPECT_EQ(std::get<protocol::CreateMatch>(std::get<protocol::EntryCommand>(message->body)).name,
              "Ann");
}

// code-server 6161: a proxy that names the default port.
TEST(Intake, APageBehindAProxyThatNamesItsPortMayConnect) {
    const RunningServer server;
    for (const char* host : {"name:443", "name:80", "name"}) {
        const std::string answer =
            exchange(server.address(),
                     "GET /ws HTTP/1.1\r\nHost: "s + host +
                         "\r\nOrigin: https://name\r\nConnection: Upgrade\r\nUpgrade: websocket\r\n"
                         "Sec-WebSocket-Version: 12\r\nSec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA=="
                         "\r\n\r\n");
        EXPECT_NE(answer.substr(0, 12), "HTTP/1.1 403") << host;
    }
}

// labelme 2485: a link in place of the file, and its mode.
TEST(Intake, AnExportToALinkWritesItsTargetAndKeepsItsMode) {
    const server::test::TempFolder folder;
    const auto target = folder.path() / "private.jsonl";
    const auto link = folder.path() / "link.jsonl";
    std::ofstream(target) << "old";
    std::filesystem::permissions(target, static_cast<std::filesystem::perms>(0600));
    std::filesystem::create_symlink(target, link);
    files::OutputFile output(link);
    output.stream() << "new";
    output.finish();
    EXPECT_TRUE(std::filesystem::is_symlink(link));
    EXPECT_EQ(std::filesystem::status(target).permissions(),
              static_cast<std::filesystem::perms>(0600));
    std::ostringstream text;
    text << std::ifstream(target).rdbuf();
    EXPECT_EQ(text.str(), "new");
}

TEST(Intake, SilentConnectionsDoNotKeepHealthChecksOut) {
    server::ServerConfig config;
    config.max_sessions = 2;
    const RunningServer server(config);
    const server::test::SilentConnections silent(server.address(), 64 + 2);
    EXPECT_EQ(server::test::http_get(server.address(), "/healthz").status, 200);
}

TEST(Intake, RequestsAreReadAsRfc9112HasThem) {
    const RunningServer server;
    const auto status = [&](const std::string& request) {
        return exchange(server.address(), request + "Connection: close\r\n\r\n").substr(9, 3);
    };
    EXPECT_EQ(status("GET http://a/healthz HTTP/1.1\r\nHost: a\r\n"), "200");
    EXPECT_EQ(status("GET /healthz HTTP/1.1\r\n"), "400");
    EXPECT_EQ(status("GET /healthz HTTP/1.1\r\nHost: a\r\nHost: b\r\n"), "400");
    EXPECT_EQ(status("\r\nGET /healthz HTTP/1.1\r\nHost: a\r\n"), "200");
}

}  // namespace
}  // namespace poolhall
