#include "server/room/roster.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace poolhall::server {

std::optional<Seat> Roster::open_seat() const {
    for (const Seat seat : kSeats)
        if (!holder(seat)) return seat;
    return std::nullopt;
}

const std::optional<SeatHolder>& Roster::holder(Seat seat) const {
    return seats_[seat.value];
}

bool Roster::holds(MemberId member, Seat seat) const {
    return holder(seat) && holder(seat)->member == member;
}

std::vector<Seat> Roster::seats_of(MemberId member) const {
    std::vector<Seat> seats;
    for (const Seat seat : kSeats)
        if (holds(member, seat)) seats.push_back(seat);
    return seats;
}

std::vector<Seat> Roster::seats_of(const TokenHash& token) const {
    std::vector<Seat> seats;
    for (const Seat seat : kSeats)
        if (holder(seat) && same_token(holder(seat)->token, token)) seats.push_back(seat);
    return seats;
}

std::uint32_t Roster::spectators() const {
    return static_cast<std::uint32_t>(spectators_.size());
}

std::string Roster::spectator_name(MemberId member) const {
    const auto found = spectators_.find(member);
    return found == spectators_.end() ? std::string() : found->second;
}

bool Roster::deserted() const {
    return std::none_of(seats_.begin(), seats_.end(),
                        [](const auto& seat) { return seat.has_value(); });
}

bool Roster::attended() const {
    return std::any_of(seats_.begin(), seats_.end(),
                       [](const auto& seat) { return seat && seat->member; });
}

void Roster::take_seat(Seat seat, SeatHolder holder) {
    assert(!seat_at(seat));
    if (holder.member) spectators_.erase(*holder.member);
    seat_at(seat) = std::move(holder);
}

void Roster::leave_seat(Seat seat) {
    const std::optional<SeatHolder> left = std::exchange(seat_at(seat), std::nullopt);
    if (left && left->member && seats_of(*left->member).empty()) watch(*left->member, left->name);
}

void Roster::watch(MemberId member, std::string name) {
    spectators_[member] = std::move(name);
}

std::vector<Seat> Roster::leave(MemberId member) {
    std::vector<Seat> seats = seats_of(member);
    for (const Seat seat : seats)
        leave_seat(seat);
    spectators_.erase(member);
    return seats;
}

void Roster::disconnect(MemberId member) {
    for (const Seat seat : seats_of(member))
        seat_at(seat)->member.reset();
    spectators_.erase(member);
}

std::optional<MemberId> Roster::resume(const TokenHash& token, MemberId member) {
    std::optional<MemberId> replaced;
    for (const Seat seat : seats_of(token)) {
        if (seat_at(seat)->member) replaced = seat_at(seat)->member;
        seat_at(seat)->member = member;
    }
    return replaced;
}

}  // namespace poolhall::server
