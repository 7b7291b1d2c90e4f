// Coming and going: who sits at the table, who watches.
#include "server/base/identity.hpp"
#include "server/base/log_text.hpp"
#include "server/room/room.hpp"

#include <spdlog/spdlog.h>
#include <utility>

namespace poolhall::server {

using protocol::RejectCode;
using protocol::Stream;

/// Somebody takes a seat, maybe with the whole match still to be begun.
struct Room::Admission {
    Seat seat;
    std::string name;
    Stream stream = Stream::kStates;
    std::vector<StoreJob> before;  ///< stored ahead of the seat
};

void Room::on(const Request& request, const protocol::CreateMatch& command) {
    protocol::MatchRecord record{match_.id(), std::string(match_.rules().name),
                                 std::string(kServerName), unix_ms()};
    if (match_.settings() != GameSettings{}) record.settings = match_.settings();
    const protocol::GameRecord game{match_.game_number(), match_.game().turn};
    admit(request, {Seat{0},
                    command.name,
                    command.stream,
                    {CreateMatchJob{match_.code(), record}, AppendGameJob{match_.id(), game}}});
}

void Room::on(const Request& request, const protocol::JoinMatch& command) {
    admit(request, {*match_.open_seat(), command.name, command.stream, {}});
}

void Room::admit(const Request& request, const Admission& admission) {
    const std::string token = new_token();
    SeatHolder holder{admission.name, hash_token(token), request.member.id};
    std::vector<StoreJob> jobs = admission.before;
    jobs.push_back(seat_job(admission.seat, holder.name, holder.token));
    const bool created = !admission.before.empty();
    store(std::move(jobs),
          [=, this, seat = admission.seat, stream = admission.stream](const auto& error) {
              if (error) {
                  reject(request, {RejectCode::kStorage, *error});
                  if (created) close("it could not be stored");
                  return;
              }
              match_.take_seat(seat, holder);
              spdlog::info("match {} {}: {} takes seat {}", match_.id(),
                           created ? "created" : "joined", in_quotes(holder.name), seat.value);
              joined(request, stream, token);
          });
}

void Room::on(const Request& request, const protocol::WatchMatch& command) {
    match_.watch(request.member.id, command.name);
    joined(request, command.stream, {});
}

void Room::on(const Request& request, const protocol::Resume& command) {
    if (const auto replaced = match_.resume(hash_token(command.token), request.member.id))
        replace(*replaced);
    joined(request, command.stream, command.token);
}

/// A newer connection has the seats: the older must not come back and take them again.
void Room::replace(MemberId member) {
    if (const Member* older = followers_.find(member))
        older->loop->post([outlet = older->outlet] {
            outlet->close(CloseReason::kPolicy, "Your seat was resumed from another connection.");
        });
    followers_.remove(member);
}

void Room::joined(const Request& request, Stream stream, const std::string& token) {
    const bool seated = !match_.seats_of(request.member.id).empty();
    // To the others first: the newcomer's table already has itself in it.
    if (seated)
        announce_table();
    else
        spectators_.request();
    FanOut::send(request.member,
                 protocol::Joined{request.message.seq, token, match_.seats_of(request.member.id),
                                  match_.table()});
    followers_.add(request.member, stream);
    finish(request);
}

/// A spectator, who may have come without a name, as a player.
SeatHolder Room::newcomer(MemberId member, const std::string& token) const {
    std::string name = match_.spectator_name(member);
    return {name.empty() ? "Guest" : std::move(name), hash_token(token), member};
}

void Room::on(const Request& request, const protocol::TakeSeat& command) {
    const auto seats = match_.seats_of(request.member.id);
    const bool seated = !seats.empty();
    // One token for all of a person's seats; a spectator has none yet and is answered with one.
    const std::string token = seated ? std::string() : new_token();
    const SeatHolder holder =
        seated ? *match_.holder(seats.front()) : newcomer(request.member.id, token);
    store({seat_job(command.seat, holder.name, holder.token)}, [=, this](const auto& error) {
        if (error) return reject(request, {RejectCode::kStorage, *error});
        match_.take_seat(command.seat, holder);
        if (seated)
            accept(request);
        else
            FanOut::send(request.member,
                         protocol::Joined{request.message.seq, token,
                                          match_.seats_of(request.member.id), match_.table()});
        announce_table();
        finish(request);
    });
}

void Room::on(const Request& request, const protocol::LeaveSeat& command) {
    store({seat_job(command.seat, {}, {})}, [=, this](const auto& error) {
        if (error) return reject(request, {RejectCode::kStorage, *error});
        match_.leave_seat(command.seat);
        accept(request);
        announce_table();
        finish(request);
    });
}

void Room::on(const Request& request, const protocol::Leave&) {
    const auto leave = [=, this](const std::optional<std::string>& error) {
        if (error) return reject(request, {RejectCode::kStorage, *error});
        match_.leave(request.member.id);
        accept(request);
        remove(request.member.id);
        request.done({});
    };
    std::vector<StoreJob> jobs;
    for (const Seat seat : match_.seats_of(request.member.id))
        jobs.push_back(seat_job(seat, {}, {}));
    if (jobs.empty()) return leave({});
    store(std::move(jobs), leave);
}

void Room::remove(MemberId member) {
    if (!followers_.find(member)) return;
    followers_.remove(member);
    empty_since_ = Clock::now();
    if (match_.deserted() && followers_.empty() && !closed_) return close("everybody left");
    spectators_.request();
}

StoreJob Room::seat_job(Seat seat, const std::string& name, const TokenHash& token) const {
    return SetSeatJob{match_.id(), {seat, name}, token};
}

}  // namespace poolhall::server
