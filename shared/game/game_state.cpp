#include "shared/game/game_state.hpp"

#include "shared/math/state_hash.hpp"
#include "shared/physics/scene/trace.hpp"

#include <array>

namespace poolhall {

namespace {

void add(StateHash& hash, const EndGamePart& part) {
    hash.add(std::uint64_t{part.in_hand});
}

}  // namespace

std::uint64_t hash_of(const GameState& state) {
    StateHash hash;
    hash.add(hash_of(state.scene));
    hash.add(std::uint64_t{state.cue_ball.value});
    hash.add(std::uint64_t{state.turn.value});
    hash.add(std::uint64_t{state.shots});
    hash.add(std::uint64_t{state.over});
    hash.add(std::uint64_t{state.winner ? 1U + state.winner->value : 0U});
    hash.add(std::uint64_t{state.part.index()});
    std::visit([&](const auto& part) { add(hash, part); }, state.part);
    return hash.value();
}

std::string_view name(Verdict verdict) {
    constexpr std::array<std::string_view, 5> kNames{"turn_passes", "won", "scratch", "conceded",
                                                     "timed_out"};
    return kNames[static_cast<std::size_t>(verdict)];
}

}  // namespace poolhall
