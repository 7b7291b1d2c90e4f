#include "server/http/routes.hpp"

#include "protocol/limits.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>
#include <string>
#include <utility>

namespace poolhall::server {
namespace {

using nlohmann::json;

constexpr std::size_t kDefaultPage = 50;
constexpr std::size_t kMaxPage = 500;
constexpr std::string_view kReplays = "/api/replays";

HttpReply json_reply(const json& body) {
    return {200, "application/json", body.dump() + "\n", {}};
}

json to_json(const MatchSummary& match) {
    json seats = json::array();
    for (const protocol::SeatInfo& seat : match.seats)
        seats.push_back({{"taken", seat.taken},
                         {"connected", seat.connected},
                         {"name", seat.name},
                         {"wins", seat.wins}});
    json listed{{"match", match.id},          {"game", match.game},
                {"phase", name(match.phase)}, {"game_number", match.game_number},
                {"shots", match.shots},       {"spectators", match.spectators},
                {"seats", std::move(seats)}};
    if (!match.code.empty()) listed["code"] = match.code;
    return listed;
}

HttpReply list_matches(const Lobby& lobby) {
    json matches = json::array();
    for (const MatchSummary& match : lobby.list())
        matches.push_back(to_json(match));
    return json_reply({{"matches", std::move(matches)}});
}

/// CPU time of simulations, as a summary without quantiles.
std::string metrics_of(const ShotCosts& costs) {
    std::string text = "# TYPE poolhall_shot_cpu_seconds summary\n";
    for (const ShotCosts::Sum& sum : costs.sums()) {
        const std::string labels =
            fmt::format(R"({{solver="{}",kernel="{}"}})", name(sum.solver), sum.kernel);
        const std::chrono::duration<double> seconds = sum.cpu;
        text += fmt::format("poolhall_shot_cpu_seconds_sum{} {}\n", labels, seconds.count());
        text += fmt::format("poolhall_shot_cpu_seconds_count{} {}\n", labels, sum.shots);
    }
    return text;
}

HttpReply metrics(const Counters& counters) {
    std::string text;
    const auto add = [&](std::string_view name, std::string_view type, auto value) {
        text += "# TYPE poolhall_" + std::string(name) + " " + std::string(type) + "\n";
        text += "poolhall_" + std::string(name) + " " + std::to_string(value) + "\n";
    };
    add("connections", "gauge", counters.connections.load());
    add("connections_refused_total", "counter", counters.connections_refused.load());
    add("connections_evicted_total", "counter", counters.connections_evicted.load());
    add("sessions", "gauge", counters.sessions.load());
    add("matches", "gauge", counters.matches.load());
    add("shots_total", "counter", counters.shots.load());
    add("messages_sent_total", "counter", counters.messages_sent.load());
    add("message_bytes_sent_total", "counter", counters.bytes_sent.load());
    add("rejects_total", "counter", counters.rejects.load());
    text += metrics_of(counters.shot_costs);
    return {200, "text/plain; version=0.0.4", std::move(text), {}};
}

// ---- replays

HttpReply storage_failure(const std::string& reason) {
    spdlog::error("replays cannot be read: {}", reason);
    return error_reply(500, "The replay store cannot be read.");
}

HttpReply list_replays(const ReplayStore& store, std::size_t limit,
                       std::optional<std::uint64_t> before) {
    const auto archive = store.open_archive();
    if (!archive) return storage_failure(archive.error().reason);
    const auto page = archive->list(limit, before);
    if (!page) return storage_failure(page.error().reason);
    json replays = json::array();
    for (const protocol::ReplaySummary& replay : *page) {
        json listed{{"id", replay.id},       {"position", replay.position},
                    {"game", replay.game},   {"names", replay.names},
                    {"shots", replay.shots}, {"games", replay.games},
                    {"wins", replay.wins},   {"created_ms", replay.created_ms}};
        if (replay.closed_ms) listed["closed_ms"] = *replay.closed_ms;
        replays.push_back(std::move(listed));
    }
    return json_reply({{"replays", std::move(replays)}});
}

HttpReply export_replay(const ReplayStore& store, const std::string& id) {
    const auto archive = store.open_archive();
    if (!archive) return storage_failure(archive.error().reason);
    const auto lines = archive->export_match(id);
    if (!lines) return storage_failure(lines.error().reason);
    if (!*lines) return error_reply(404, "There is no replay of this id.");
    return {200,
            "application/x-ndjson",
            **lines,
            {{"Content-Disposition", "attachment; filename=\"" + id + ".jsonl\""}}};
}

/// Ids are our own hex digits: nothing else is looked up, so nothing in one can mean a path.
bool is_replay_id(std::string_view id) {
    return !id.empty() && id.size() <= 64 &&
           id.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

/// The whole of `text` as a number.
std::optional<std::uint64_t> parse_number(std::string_view text) {
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return number;
}

Route answer(HttpReply reply) {
    return {false, [reply = std::move(reply)] { return reply; }};
}

/// ?limit=N&before=POSITION
Route list_route(const ReplayStore& store, std::string_view query) {
    std::size_t limit = kDefaultPage;
    std::optional<std::uint64_t> before;
    while (!query.empty()) {
        const std::string_view field = query.substr(0, query.find('&'));
        query.remove_prefix(std::min(query.size(), field.size() + 1));
        const std::size_t equals = std::min(field.find('='), field.size());
        const auto number = parse_number(field.substr(std::min(equals + 1, field.size())));
        const std::string_view key = field.substr(0, equals);
        if (key == "limit" && number && *number >= 1 && *number <= kMaxPage)
            limit = *number;
        else if (key == "before" && number)
            before = *number;
        else
            return answer(
                error_reply(400, "The query takes limit (1 to 500) and before (a position)."));
    }
    return {true, [&store, limit, before] { return list_replays(store, limit, before); }};
}

Route find_get(const RouteServices& services, std::string_view path, std::string_view query) {
    if (path == "/healthz") return answer({200, "text/plain", "ok\n", {}});
    if (path == "/readyz")
        return answer(services.ready() ? HttpReply{200, "text/plain", "ready\n", {}}
                                       : error_reply(503, "The server is shutting down."));
    if (path == "/metrics") return {false, [&services] { return metrics(services.counters); }};
    if (path == "/api/matches") return {true, [&services] { return list_matches(services.lobby); }};
    if (path == kReplays) return list_route(services.store, query);
    if (path.starts_with(kReplays) && path[kReplays.size()] == '/') {
        const std::string id(path.substr(kReplays.size() + 1));
        if (!is_replay_id(id))
            return answer(error_reply(400, "A replay's id is made of the digits 0-9 and a-f."));
        return {true, [&services, id] { return export_replay(services.store, id); }};
    }
    if (path == protocol::kPath) {
        HttpReply reply = error_reply(426, "This is a WebSocket address.");
        reply.headers.emplace_back("Upgrade", "websocket");
        return answer(std::move(reply));
    }
    return answer(error_reply(404, "There is nothing here."));
}

}  // namespace

HttpReply error_reply(int status, const std::string& sentence) {
    return {status, "application/json", json{{"error", sentence}}.dump() + "\n", {}};
}

bool is_health_check(std::string_view target) {
    const std::string_view path = target.substr(0, target.find('?'));
    return path == "/healthz" || path == "/readyz" || path == "/metrics";
}

Route find_route(const RouteServices& services, std::string_view method, std::string_view target) {
    const std::string_view path = target.substr(0, target.find('?'));
    const std::string_view query = target.substr(std::min(target.size(), path.size() + 1));
    Route route = find_get(services, path, query);
    if (method == "GET" || method == "HEAD") return route;
    HttpReply reply = error_reply(405, "Only GET and HEAD are answered here.");
    reply.headers.emplace_back("Allow", "GET, HEAD");
    return answer(std::move(reply));
}

}  // namespace poolhall::server
