#include "shared/physics/scene/trace.hpp"

#include "shared/math/state_hash.hpp"

namespace poolhall {

std::string_view pocket_id(const Table& table, Pocket pocket) {
    if (table.pockets == PocketModel::kCircles)
        return table.circles[static_cast<std::size_t>(pocket)].id;
    return name(pocket);
}

std::uint64_t hash_of(const ShotTrace& trace) {
    StateHash hash;
    for (const ShotEvent& event : trace.events) {
        hash.add(static_cast<std::uint64_t>(event.kind));
        for (std::size_t i = 0; i < event.ball_count; ++i)
            hash.add(std::uint64_t{event.balls[i].value});
        hash.add(event.t);
    }
    for (const FinalBall& ball : trace.balls) {
        hash.add(static_cast<std::uint64_t>(ball.motion));
        for_each_field(ball.state, [&](const auto&, const Vec3& member) { hash.add(member); });
    }
    return hash.value();
}

std::string to_hex(std::uint64_t hash) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string text(16, '0');
    for (std::size_t i = text.size(); i-- > 0; hash >>= 4U)
        text[i] = kDigits[hash & 15U];
    return text;
}

}  // namespace poolhall
