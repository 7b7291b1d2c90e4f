#include "tests/server/support/table.hpp"

#include <nlohmann/json.hpp>

namespace poolhall::server::test {
namespace {

using nlohmann::json;

TEST(Http, HealthAndReadinessAreAnswered) {
    RunningServer server;
    EXPECT_EQ(http_get(server.address(), "/healthz").status, 200);
    EXPECT_EQ(http_get(server.address(), "/readyz").status, 200);
    EXPECT_EQ(http_get(server.address(), "/healthz", "HEAD").status, 200);
}

TEST(Http, MatchesAreListedWithACodeOnceNobodyCanJoin) {
    RunningServer server;
    Client ada(server.json());
    ada.send(protocol::CreateMatch{"Ada"});
    const auto joined = ada.expect<protocol::Joined>();
    const auto list = [&] {
        return json::parse(http_get(server.address(), "/api/matches").body).at("matches");
    };
    ASSERT_EQ(list().size(), 1U);
    EXPECT_EQ(list()[0].at("phase"), "waiting");
    EXPECT_EQ(list()[0].at("seats")[0].at("name"), "Ada");
    EXPECT_FALSE(list()[0].contains("code")) << "a stranger could take the open seat";
    ASSERT_FALSE(ada.ask(protocol::TakeSeat{Seat{1}}));
    EXPECT_TRUE(eventually([&] { return list()[0].value("code", "") == joined.table.code; }));
}

TEST(Http, ReplaysAreListedAndExported) {
    RunningServer server;
    Table table(server);
    table.play(Seat{0}, kScratchDirection);
    const json list = json::parse(http_get(server.address(), "/api/replays").body).at("replays");
    ASSERT_EQ(list.size(), 1U);
    EXPECT_EQ(list[0].at("shots"), 1);
    EXPECT_EQ(list[0].at("names"), (json{"Ada", "Ben"}));
    EXPECT_EQ(list[0].at("games"), 1);
    EXPECT_EQ(list[0].at("wins"), (json{0, 1}));
    const std::string id = list[0].at("id");
    EXPECT_EQ(id, table.joined[0].table.match);
    const HttpAnswer replay = http_get(server.address(), "/api/replays/" + id);
    EXPECT_EQ(replay.status, 200);
    EXPECT_EQ(replay.type, "application/x-ndjson");
    EXPECT_NE(replay.body.find("\"shot\""), std::string::npos);
    EXPECT_EQ(replay.body.find(table.joined[0].token), std::string::npos);
    EXPECT_EQ(
        json::parse(
            http_get(server.address(), "/api/replays?before=" + list[0].at("position").dump()).body)
            .at("replays")
            .size(),
        0U);
}

TEST(Http, WhatIsNotThereOrNotAllowedIsSaid) {
    RunningServer server;
    const std::string address = server.address();
    EXPECT_EQ(http_get(address, "/nowhere").status, 404);
    EXPECT_EQ(http_get(address, "/api/replays/0123456789abcdef").status, 404);
    EXPECT_EQ(http_get(address, "/api/replays/../../../etc/passwd").status, 400);
    EXPECT_EQ(http_get(address, "/api/replays/%2e%2e").status, 400);
    EXPECT_EQ(http_get(address, "/api/replays?limit=1000000").status, 400);
    EXPECT_EQ(http_get(address, "/api/matches", "POST").status, 405);
    EXPECT_EQ(http_get(address, "/ws").status, 426);
    EXPECT_TRUE(json::parse(http_get(address, "/nowhere").body).contains("error"));
}

TEST(Http, RequestsThatAreNoneAreRefused) {
    RunningServer server;
    const auto status = [&](const std::string& bytes) {
        return exchange(server.address(), bytes).substr(0, 12);
    };
    EXPECT_EQ(status("hello\r\n\r\n"), "HTTP/1.1 400");
    EXPECT_EQ(status("GET / HTTP/1.1\r\nX: " + std::string(20'000, 'x') + "\r\n\r\n"),
              "HTTP/1.1 431");
    EXPECT_EQ(status("POST / HTTP/1.1\r\nContent-Length: 999999\r\n\r\n"), "HTTP/1.1 413");
    EXPECT_EQ(http_get(server.address(), "/healthz").status, 200);
}

/// The status line's beginning that answers the bytes.
std::string status_of(const RunningServer& server, const std::string& bytes) {
    return exchange(server.address(), bytes).substr(0, 12);
}

TEST(Http, RequestsAreReadAsRfc9112HasThem) {
    RunningServer server;
    const std::string good = "HTTP/1.1 200";
    const std::string close = "Connection: close\r\n\r\n";
    for (const char* request :
         {"GET /healthz HTTP/1.1\r\nHost: a\r\n", "\r\nGET /healthz HTTP/1.1\r\nHost: a\r\n",
          "\r\n\r\n\r\nGET /healthz HTTP/1.1\r\nHost:\r\n",
          "GET http://elsewhere/healthz HTTP/1.1\r\nHost: a\r\n",
          "GET HTTP://a:80/healthz?x HTTP/1.1\r\nhost: b\r\n",
          "GET /healthz HTTP/1.1\r\nHost: [::1]:80\r\nX: folded\r\n  value\r\n"})
        EXPECT_EQ(status_of(server, request + close), good) << request;
    EXPECT_EQ(status_of(server, "GET /healthz HTTP/1.0\r\n\r\n"), "HTTP/1.0 200");
    for (const char* request :
         {"GET /healthz HTTP/1.1\r\n", "GET /healthz HTTP/1.1\r\nHost: a\r\nHost: a\r\n",
          "GET /healthz HTTP/1.1\r\nHost: a b\r\n", "GET /healthz HTTP/1.1\r\nHost: a@b\r\n",
          "GET /healthz HTTP/1.1\r\nHost: a:b\r\n", "GET http:///x HTTP/1.1\r\nHost: a\r\n",
          "GET /healthz HTTP/1.1\r\nHost: a\r\n b\r\n", "GET /healthz HTTP/1.1\r\nHost : a\r\n"})
        EXPECT_EQ(status_of(server, request + close), "HTTP/1.1 400") << request;
    EXPECT_EQ(status_of(server, "GET http://a/nowhere HTTP/1.1\r\nHost: a\r\n" + close),
              "HTTP/1.1 404");
}

TEST(Http, EmptyLinesMayStandBetweenRequestsOfOneConnection) {
    RunningServer server;
    const std::string get = "GET /healthz HTTP/1.1\r\nHost: a\r\n";
    const std::string answers = exchange(server.address(), get + "\r\n\r\n" + get + "\r\n\r\n\r\n" +
                                                               get + "Connection: close\r\n\r\n");
    std::size_t count = 0;
    for (std::size_t at = 0; (at = answers.find("HTTP/1.1 200", at)) != std::string::npos; ++at)
        ++count;
    EXPECT_EQ(count, 3U);
}

TEST(Http, SilentConnectionsOfOneAddressKeepNobodyOut) {
    ServerConfig config;
    config.max_sessions = 4;
    for (const std::uint32_t per_address : {0U, 10U, 1000U}) {
        config.max_per_address = per_address;
        RunningServer server(config);
        const SilentConnections silent(server.address(), 200);
        const auto begin = std::chrono::steady_clock::now();
        EXPECT_EQ(http_get(server.address(), "/healthz").status, 200);
        EXPECT_EQ(http_get(server.address(), "/api/matches").status, 200);
        Client player(server.json());
        player.expect<protocol::Welcome>();
        EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5));
        const std::string metrics = http_get(server.address(), "/metrics").body;
        EXPECT_EQ(metrics.find("\npoolhall_connections_evicted_total 0\n"), std::string::npos);
        const std::size_t bound = per_address == 10U ? 10 : 68;
        EXPECT_LE(server.server().counters().connections.load(), static_cast<std::int64_t>(bound));
    }
}

TEST(Http, HealthIsAnsweredWhileSessionsHaveAllThatTheirAddressMayHave) {
    ServerConfig config;
    config.max_per_address = 2;
    RunningServer server(config);
    const Table table(server);
    EXPECT_EQ(http_get(server.address(), "/healthz").status, 200);
    EXPECT_EQ(http_get(server.address(), "/readyz").status, 200);
    EXPECT_EQ(http_get(server.address(), "/metrics").status, 200);
    EXPECT_EQ(http_get(server.address(), "/api/matches").status, 503);
    EXPECT_EQ(refused_handshake(server.json()).status, 503);
}

TEST(Http, MetricsCountShots) {
    RunningServer server;
    Table table(server);
    table.play(Seat{0}, kScratchDirection);
    const std::string metrics = http_get(server.address(), "/metrics").body;
    EXPECT_NE(metrics.find("\npoolhall_shots_total 1\n"), std::string::npos) << metrics;
    EXPECT_NE(metrics.find("\npoolhall_sessions 2\n"), std::string::npos) << metrics;
}

TEST(Http, MetricsTellWhatSimulationsCostBySolverAndKernel) {
    RunningServer server;
    Table table(server);
    const double cpu_us = table.play(Seat{0}, kScratchDirection).cpu_us;
    EXPECT_GT(cpu_us, 0);
    const std::string metrics = http_get(server.address(), "/metrics").body;
    const std::string labels = R"({solver="euler",kernel="drag_rails_pockets"} )";
    EXPECT_NE(metrics.find("poolhall_shot_cpu_seconds_count" + labels + "1\n"), std::string::npos)
        << metrics;
    const std::string sum = "poolhall_shot_cpu_seconds_sum" + labels;
    const std::size_t at = metrics.find(sum);
    ASSERT_NE(at, std::string::npos) << metrics;
    EXPECT_DOUBLE_EQ(std::stod(metrics.substr(at + sum.size())) * 1e6, cpu_us);
}

TEST(Http, HandshakesThatAreRefusedGetAnHttpAnswer) {
    RunningServer server;
    ConnectSpec spec = server.json();
    spec.subprotocol = "poolhall.v9";
    EXPECT_EQ(refused_handshake(spec).status, 400);
    spec = server.json();
    spec.origin = "http://evil.example";
    EXPECT_EQ(refused_handshake(spec).status, 403);
    spec = server.json();
    spec.target = "/elsewhere";
    EXPECT_EQ(refused_handshake(spec).status, 404);
}

TEST(Http, FullServerRefusesTheNextSession) {
    ServerConfig config;
    config.max_sessions = 1;
    RunningServer server(config);
    Client first(server.json());
    first.expect<protocol::Welcome>();
    EXPECT_EQ(refused_handshake(server.json()).status, 503);
}

}  // namespace
}  // namespace poolhall::server::test
