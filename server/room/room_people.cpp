// Coming and going: who sits at the table, who watches.
#include "server/base/identity.hpp"
#include "server/base/log_text.hpp"
#include "server/room/room.hpp"

#include <spdlog/spdlog.h>

namespace poolhall::server {

using protocol::RejectCode;
using protocol::Stream;

/// Somebody takes a seat, maybe with the whole match still to be begun.
struct Room::Admission {
    Seat seat;
    std::string name;
    Stream stream = Stream::kStates;
    std::optional<StoreJob> creation;  ///< stored ahead of the seat
};

void Room::on(Request request, const protocol::CreateMatch& command) {
    protocol::MatchRecord record;
    record.match = table_.id;
    record.game = table_.match.rules().name;
    record.server = kServerName;
    record.created_ms = unix_ms();
    if (table_.match.settings() != MatchSettings{}) record.settings = table_.match.settings();
    record.first = table_.match.now().first;
    admit(std::move(request),
          {Seat{0}, command.name, command.stream, CreateMatchJob{table_.code, std::move(record)}});
}

void Room::on(Request request, const protocol::JoinMatch& command) {
    admit(std::move(request), {*table_.roster.open_seat(), command.name, command.stream, {}});
}

void Room::admit(Request request, Admission admission) {
    std::string token = new_token();
    SeatHolder holder{admission.name, hash_token(token), request.member().id};
    std::vector<StoreJob> jobs;
    const bool creates = admission.creation.has_value();
    if (creates) jobs.push_back(*std::move(admission.creation));
    jobs.push_back(seat_job(admission.seat, holder.name, holder.token));
    store(std::move(jobs), [=, this, request = std::move(request), seat = admission.seat,
                            stream = admission.stream](const auto& error) mutable {
        if (error) {
            std::move(request).reject({RejectCode::kStorage, *error});
            if (creates) close("it could not be stored");
            return;
        }
        spdlog::info("match {} {}: {} takes seat {}", table_.id, creates ? "created" : "joined",
                     in_quotes(holder.name), seat.value);
        table_.take_seat(seat, std::move(holder));
        enter(std::move(request), stream, std::move(token));
    });
}

void Room::on(Request request, const protocol::WatchMatch& command) {
    table_.roster.watch(request.member().id, command.name);
    enter(std::move(request), command.stream, {});
}

void Room::on(Request request, const protocol::Resume& command) {
    const auto replaced = table_.roster.resume(hash_token(command.token), request.member().id);
    if (replaced) replace(*replaced);
    enter(std::move(request), command.stream, command.token);
}

/// A newer connection has the seats: the older must not come back and take them again.
void Room::replace(MemberId member) {
    if (const Member* older = followers_.find(member))
        services_.shards.post(*older, [](Outlet& outlet) {
            outlet.close(CloseReason::kPolicy, "Your seat was resumed from another connection.");
        });
    followers_.remove(member);
}

void Room::enter(Request request, Stream stream, std::string token) {
    const Member member = request.member();
    // To the others first: the newcomer's table already has itself in it.
    if (!table_.roster.seats_of(member.id).empty())
        announce_table();
    else
        spectators_.request();
    followers_.add(member, stream);
    std::move(request).join(joined(member.id, std::move(token)), standing_of(member.id));
}

protocol::Joined Room::joined(MemberId member, std::string token) const {
    return {0, std::move(token), table_.roster.seats_of(member), state_of(table_, unix_ms())};
}

Standing Room::standing_of(MemberId member) {
    return {shared_from_this(), !table_.roster.seats_of(member).empty()};
}

/// A spectator, who may have come without a name, as a player.
SeatHolder Room::newcomer(MemberId member, const std::string& token) const {
    std::string name = table_.roster.spectator_name(member);
    return {name.empty() ? "Guest" : std::move(name), hash_token(token), member};
}

void Room::on(Request request, const protocol::TakeSeat& command) {
    const MemberId member = request.member().id;
    const auto seats = table_.roster.seats_of(member);
    // One token for all of a person's seats; a spectator has none yet and is answered with one.
    std::string token = seats.empty() ? new_token() : std::string();
    SeatHolder holder =
        seats.empty() ? newcomer(member, token) : *table_.roster.holder(seats.front());
    StoreJob job = seat_job(command.seat, holder.name, holder.token);
    store({std::move(job)}, [=, this, request = std::move(request)](const auto& error) mutable {
        if (error) return std::move(request).reject({RejectCode::kStorage, *error});
        table_.take_seat(command.seat, std::move(holder));
        keep_clock();
        if (token.empty())
            std::move(request).accept(standing_of(member));
        else
            std::move(request).join(joined(member, std::move(token)), standing_of(member));
        announce_table();
    });
}

void Room::on(Request request, const protocol::LeaveSeat& command) {
    store({seat_job(command.seat, {}, {})},
          [=, this, request = std::move(request)](const auto& error) mutable {
              if (error) return std::move(request).reject({RejectCode::kStorage, *error});
              const MemberId member = request.member().id;
              table_.leave_seat(command.seat);
              std::move(request).accept(standing_of(member));
              announce_table();
          });
}

void Room::on(Request request, const protocol::Leave&) {
    std::vector<StoreJob> jobs;
    for (const Seat seat : table_.roster.seats_of(request.member().id))
        jobs.push_back(seat_job(seat, {}, {}));
    const bool nothing_to_store = jobs.empty();
    auto leave = [this, request = std::move(request)](const StoreError& error) mutable {
        if (error) return std::move(request).reject({RejectCode::kStorage, *error});
        const MemberId member = request.member().id;
        table_.leave(member);
        std::move(request).accept({});
        remove(member);
    };
    if (nothing_to_store) return leave({});
    store(std::move(jobs), std::move(leave));
}

void Room::remove(MemberId member) {
    if (!followers_.find(member)) return;
    followers_.remove(member);
    empty_since_ = Clock::now();
    if (table_.roster.deserted() && followers_.empty() && !closed_) return close("everybody left");
    keep_clock();
    spectators_.request();
}

StoreJob Room::seat_job(Seat seat, const std::string& name, const TokenHash& token) const {
    return SetSeatJob{table_.id, {seat, name}, token};
}

}  // namespace poolhall::server
