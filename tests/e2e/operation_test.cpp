#include "tests/e2e/server_process.hpp"
#include "tests/e2e/table.hpp"

#include <algorithm>
#include <fstream>
#include <gtest/gtest.h>
#include <signal.h>
#include <vector>

// What an operator meets: two servers, a taken port, a bad configuration, a rush of clients.
namespace poolhall::e2e {
namespace {

using namespace protocol;

/// One line on standard error that names `what`, nothing on standard output, and a failure.
void expect_refusal(const Finished& server, std::string_view what) {
    EXPECT_GT(server.status, 0);
    EXPECT_EQ(server.out, "");
    EXPECT_EQ(std::count(server.err.begin(), server.err.end(), '\n'), 1) << server.err;
    EXPECT_NE(server.err.find(what), std::string::npos) << server.err;
}

TEST(Operation, ServerThatIsAskedToEndDoesSoWithoutAnError) {
    const TemporaryFolder data;
    ServerProcess server(data.path());
    EXPECT_EQ(http_get(server.port(), "/healthz").status, 200);
    EXPECT_EQ(http_get(server.port(), "/readyz").status, 200);
    EXPECT_EQ(server.terminate(), 0);
    EXPECT_EQ(server.process().out(),
              "listening on 127.0.0.1:" + std::to_string(server.port()) + "\n");
}

TEST(Operation, SecondServerOnTheSameDataFolderIsRefused) {
    const TemporaryFolder data;
    ServerProcess first(data.path());
    expect_refusal(run(server_command(data.path())), data.path().string());
    EXPECT_EQ(http_get(first.port(), "/healthz").status, 200);
}

TEST(Operation, PortInUseIsNamed) {
    const TemporaryFolder data;
    const TemporaryFolder other_data;
    ServerProcess first(data.path());
    const std::string address = "127.0.0.1:" + std::to_string(first.port());
    expect_refusal(run({POOLHALL_SERVER, "--listen", address, "--data", other_data.path()}),
                   address);
}

TEST(Operation, BadCommandLineOrConfigurationIsNamed) {
    const TemporaryFolder folder;
    const std::string config = folder.path() / "server.toml";
    expect_refusal(run(server_command(folder.path(), {"--config", config})), config);
    std::ofstream(config) << "listne = \"127.0.0.1:0\"\n";
    expect_refusal(run(server_command(folder.path(), {"--config", config})), "listne");
    std::ofstream(config) << "listen = \n";
    expect_refusal(run(server_command(folder.path(), {"--config", config})), config);
    expect_refusal(run(server_command(folder.path(), {"--frobnicate"})), "frobnicate");
    expect_refusal(run({POOLHALL_SERVER, "--listen", "nowhere", "--data", folder.path()}),
                   "nowhere");
}

TEST(Operation, DataFolderThatCannotBeUsedIsNamed) {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path() / "file";
    std::ofstream(file) << "not a folder\n";
    expect_refusal(run(server_command(file)), file.string());
    std::ofstream(folder.path() / "poolhall.sqlite") << std::string(4096, 'x');
    expect_refusal(run(server_command(folder.path())), "poolhall.sqlite");
}

TEST(Operation, MatchIsPlayedThroughARushOfConnections) {
    constexpr std::size_t kRush = 500;
    const TemporaryFolder data;
    ServerProcess server(data.path());
    Duel duel(server.port());
    std::vector<ProtocolClient> rush;
    rush.reserve(kRush);
    for (std::size_t i = 0; i < kRush; ++i)
        rush.emplace_back(server.port(), i % 2 == 0 ? Encoding::kJson : Encoding::kCbor);
    for (ProtocolClient& client : rush)
        client.send(WatchMatch{duel.ann_joined.table.code, "Wanda"});
    std::size_t watching = 0;
    for (ProtocolClient& client : rush) {
        const Heard answer = client.hear();
        if (std::holds_alternative<Joined>(answer.message)) {
            ++watching;
        } else {
            const Reject* reject = std::get_if<Reject>(&answer.message);
            ASSERT_NE(reject, nullptr);
            EXPECT_EQ(reject->code, RejectCode::kSpectatorsFull);
        }
    }
    EXPECT_GT(watching, 0U);
    duel.play(Verdict::kScratch);
    rush.clear();
    EXPECT_EQ(server.terminate(), 0);
}

}  // namespace
}  // namespace poolhall::e2e
