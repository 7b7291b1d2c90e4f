#pragma once

#include "server/base/secret.hpp"
#include "server/delivery/member.hpp"
#include "shared/game/seat.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace poolhall::server {

struct SeatHolder {
    std::string name;
    TokenHash token;                 ///< brings the holder back
    std::optional<MemberId> member;  ///< the holder's connection; none while away
};

/// The people at one table: who sits at it, who watches. It knows nothing of the game.
class Roster {
  public:
    [[nodiscard]] std::optional<Seat> open_seat() const;
    [[nodiscard]] const std::optional<SeatHolder>& holder(Seat seat) const;
    [[nodiscard]] bool holds(MemberId member, Seat seat) const;
    [[nodiscard]] std::vector<Seat> seats_of(MemberId member) const;
    [[nodiscard]] std::vector<Seat> seats_of(const TokenHash& token) const;
    [[nodiscard]] std::uint32_t spectators() const;
    /// The name under which a spectator watches; empty if the member is none.
    [[nodiscard]] std::string spectator_name(MemberId member) const;
    /// Nobody holds a seat: there is nothing to come back to.
    [[nodiscard]] bool deserted() const;
    /// Somebody who holds a seat is connected.
    [[nodiscard]] bool attended() const;

    /// Takes an open seat; whoever of its holder was watching no longer is.
    void take_seat(Seat seat, SeatHolder holder);
    /// Opens the seat; a member who then holds none goes on as a spectator.
    void leave_seat(Seat seat);
    void watch(MemberId member, std::string name);
    /// The member goes for good: its seats, which are returned, open.
    std::vector<Seat> leave(MemberId member);
    /// The connection is gone: the seats stay reserved for the token.
    void disconnect(MemberId member);
    /// `member` takes over all seats of the token; returns the connection it replaces.
    std::optional<MemberId> resume(const TokenHash& token, MemberId member);

  private:
    [[nodiscard]] std::optional<SeatHolder>& seat_at(Seat seat) { return seats_[seat.value]; }

    PerSeat<std::optional<SeatHolder>> seats_;
    std::map<MemberId, std::string> spectators_;  ///< and their names
};

}  // namespace poolhall::server
