#include "client/play/client_match.hpp"

namespace poolhall::client {
namespace {

using protocol::Phase;

std::vector<Seat> who_may_agree(const MatchInfo& info) {
    std::vector<Seat> seats;
    if (info.table->phase != Phase::kOver) return seats;
    for (const Seat seat : kSeats) {
        if (info.mine[seat.value] && !info.table->seats[seat.value].wants_rematch)
            seats.push_back(seat);
    }
    return seats;
}

std::optional<Seat> who_gives_up(const MatchInfo& info) {
    if (const auto acting = info.acting_seat()) return acting;
    if (info.table->phase != Phase::kAiming || !info.seated()) return std::nullopt;
    return info.mine[0] ? Seat{0} : Seat{1};
}

}  // namespace

std::optional<Seat> MatchInfo::acting_seat() const {
    if (!table || table->phase != Phase::kAiming || !mine[table->legal.seat.value])
        return std::nullopt;
    return table->legal.seat;
}

std::vector<Seat> movers(const MatchInfo& info, const Move& move) {
    if (!info.table) return {};
    if (std::holds_alternative<Agree>(move)) return who_may_agree(info);
    const auto seat =
        std::holds_alternative<Concede>(move) ? who_gives_up(info) : info.acting_seat();
    return seat ? std::vector<Seat>{*seat} : std::vector<Seat>{};
}

}  // namespace poolhall::client
