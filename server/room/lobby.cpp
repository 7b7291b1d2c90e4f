#include "server/room/lobby.hpp"

#include "server/room/gate.hpp"

#include <utility>
#include <variant>

namespace poolhall::server {

using protocol::RejectCode;

Lobby::Lobby(LobbyServices services)
    : services_(std::move(services)),
      room_services_{services_.store, services_.shards, services_.counters, services_.limits,
                     [this](const Room& room) {
                         const std::lock_guard lock(mutex_);
                         rooms_.erase(room.code());
                         services_.counters.matches.store(static_cast<std::int64_t>(rooms_.size()));
                     }} {}

void Lobby::reopen(Table table) {
    const std::lock_guard lock(mutex_);
    add(std::move(table));
}

std::shared_ptr<Room> Lobby::add(Table table) {
    const std::string code = table.code;
    const ShardId shard{next_shard_++ % static_cast<std::uint32_t>(services_.shards.size())};
    Loop& loop = services_.shards.at(shard).loop();
    auto room = std::make_shared<Room>(loop, std::move(table), room_services_);
    rooms_[code] = room;
    services_.counters.matches.store(static_cast<std::int64_t>(rooms_.size()));
    return room;
}

void Lobby::enter(Request request, const protocol::EntryCommand& command) {
    if (request.standing().room)
        return std::move(request).reject(
            {RejectCode::kAlreadyInMatch, "You are in a match: leave it first."});
    auto room = std::visit([this](const auto& asked) { return room_for(asked); }, command);
    if (!room) return std::move(request).reject(room.error());
    (*room)->submit(std::move(request), command);
}

Lobby::FoundRoom Lobby::room_for(const protocol::CreateMatch& command) {
    if (auto refusal = check(command)) return *std::move(refusal);
    const std::lock_guard lock(mutex_);
    if (closed_) return Refusal{RejectCode::kShuttingDown, "The server is shutting down."};
    if (rooms_.size() >= services_.max_matches)
        return Refusal{RejectCode::kServerFull, "The server has as many matches as it may have."};
    std::string code = new_join_code();
    while (rooms_.contains(code))
        code = new_join_code();
    // Nobody else knows the code before its creator does.
    return add(
        Table(new_match_id(), std::move(code),
              {find_ruleset(command.game), Seat{0}, command.settings.value_or(MatchSettings{})}));
}

Lobby::FoundRoom Lobby::find(const std::string& code) const {
    const std::lock_guard lock(mutex_);
    const auto found = rooms_.find(code);
    if (found != rooms_.end()) return found->second;
    return Refusal{RejectCode::kUnknownMatch, "No match has this code."};
}

void Lobby::close() {
    const std::lock_guard lock(mutex_);
    closed_ = true;
}

void Lobby::sweep() {
    for (const auto& room : rooms())
        room->sweep();
}

std::vector<MatchSummary> Lobby::list() const {
    std::vector<MatchSummary> list;
    for (const auto& room : rooms())
        list.push_back(room->summary());
    return list;
}

std::size_t Lobby::size() const {
    const std::lock_guard lock(mutex_);
    return rooms_.size();
}

std::vector<std::shared_ptr<Room>> Lobby::rooms() const {
    const std::lock_guard lock(mutex_);
    std::vector<std::shared_ptr<Room>> rooms;
    rooms.reserve(rooms_.size());
    for (const auto& [code, room] : rooms_)
        rooms.push_back(room);
    return rooms;
}

}  // namespace poolhall::server
