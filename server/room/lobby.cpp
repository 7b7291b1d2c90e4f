#include "server/room/lobby.hpp"

#include <type_traits>
#include <utility>
#include <variant>

namespace poolhall::server {

using protocol::RejectCode;

Lobby::Lobby(LobbyServices services)
    : services_(std::move(services)),
      room_services_{services_.store, services_.counters, services_.limits,
                     [this](const Room& room) {
                         const std::lock_guard lock(mutex_);
                         rooms_.erase(room.code());
                         services_.counters.matches.store(static_cast<std::int64_t>(rooms_.size()));
                     }} {}

void Lobby::reopen(Match match) {
    const std::lock_guard lock(mutex_);
    add(std::move(match));
}

std::shared_ptr<Room> Lobby::add(Match match) {
    const std::string code = match.code();
    Loop& loop = *services_.loops[next_loop_++ % services_.loops.size()];
    auto room = std::make_shared<Room>(loop, std::move(match), room_services_);
    rooms_[code] = room;
    services_.counters.matches.store(static_cast<std::int64_t>(rooms_.size()));
    return room;
}

void Lobby::submit(const std::shared_ptr<Room>& current, Request request) {
    // Copied: the request moves on before the command has been used.
    const protocol::ClientBody body = request.message.body;
    std::visit(
        [&]<class T>(const T& command) {
            constexpr bool kCreates = std::is_same_v<T, protocol::CreateMatch>;
            constexpr bool kEnters = requires {
                command.code;
            };
            if constexpr (kCreates || kEnters) {
                // By the room: it knows where the session stays.
                if (current)
                    return current->refuse(
                        std::move(request),
                        {RejectCode::kAlreadyInMatch, "You are in a match: leave it first."});
            }
            if constexpr (kCreates)
                create(command, std::move(request));
            else if constexpr (kEnters)
                enter(command.code, std::move(request));
            else if (current)
                current->submit(std::move(request));
            else
                reject(request, {RejectCode::kNotInMatch, "You are in no match."});
        },
        body);
}

void Lobby::enter(const std::string& code, Request request) {
    if (const auto room = find(code)) return room->submit(std::move(request));
    reject(request, {RejectCode::kUnknownMatch, "No match has this code."});
}

void Lobby::create(const protocol::CreateMatch& command, Request request) {
    if (auto refusal = check(command)) return reject(request, std::move(*refusal));
    const std::lock_guard lock(mutex_);
    if (closed_)
        return reject(request, {RejectCode::kShuttingDown, "The server is shutting down."});
    if (rooms_.size() >= services_.max_matches)
        return reject(request,
                      {RejectCode::kServerFull, "The server has as many matches as it may have."});
    std::string code = new_join_code();
    while (rooms_.contains(code))
        code = new_join_code();
    // Under the lock, so that nobody reaches the room before its creator.
    add(Match({new_match_id(), std::move(code), find_ruleset(command.game), Seat{0},
               command.settings.value_or(GameSettings{})}))
        ->submit(std::move(request));
}

std::shared_ptr<Room> Lobby::find(const std::string& code) const {
    const std::lock_guard lock(mutex_);
    const auto found = rooms_.find(code);
    return found == rooms_.end() ? nullptr : found->second;
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

void Lobby::reject(const Request& request, Refusal refusal) {
    services_.counters.rejects.fetch_add(1, std::memory_order_relaxed);
    FanOut::send(request.member,
                 protocol::Reject{request.message.seq, refusal.code, std::move(refusal.reason)});
    request.done({});
}

}  // namespace poolhall::server
