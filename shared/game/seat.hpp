#pragma once

#include <array>
#include <compare>
#include <cstdint>

namespace poolhall {

/// One of the two places at the table: 0 or 1.
struct Seat {
    std::uint8_t value = 0;

    friend constexpr auto operator<=>(const Seat&, const Seat&) = default;
};

inline constexpr int kSeatCount = 2;
inline constexpr std::array<Seat, kSeatCount> kSeats{Seat{0}, Seat{1}};

constexpr Seat opponent(Seat seat) {
    return Seat{static_cast<std::uint8_t>(1 - seat.value)};
}

/// Something that each seat has.
template <class T>
using PerSeat = std::array<T, kSeatCount>;

}  // namespace poolhall
