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
