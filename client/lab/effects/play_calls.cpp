#include "client/lab/effects/play_calls.hpp"

#include "client/lab/effects/effect_prices.hpp"
#include "shared/analysis/effect_use.hpp"
#include "shared/physics/simulate.hpp"

#include <algorithm>

namespace poolhall::lab {

namespace {

std::vector<Scene> shots_of(const PlayKind& kind, std::uint64_t seed, std::size_t count) {
    Random random(seed);
    std::vector<Scene> shots;
    while (shots.size() < count) {
        Scene scene = kind.make(random);
        if (!check(scene)) shots.push_back(std::move(scene));
    }
    return shots;
}

EffectShare& share_of(const std::string& effect, std::vector<EffectShare>& shares) {
    const auto found = std::find_if(shares.begin(), shares.end(),
                                    [&](const EffectShare& one) { return one.effect == effect; });
    return found == shares.end() ? shares.emplace_back(EffectShare{effect, 0, 0}) : *found;
}

}  // namespace

PlayRow measure_play(const PlayKind& kind, std::uint64_t seed, std::size_t count,
                     const Repeats& repeats) {
    const std::vector<Scene> shots = shots_of(kind, seed, count);
    PlayRow row{std::string(kind.name), {}, {}, {}};
    for (const Scene& scene : shots) {
        for (const analysis::EffectUse& use : analysis::effect_uses(scene, simulate(scene))) {
            EffectShare& share = share_of(use.effect, row.effects);
            share.called_for += use.ruled_out ? 0 : 1;
            share.acted += use.acted ? 1 : 0;
        }
    }
    for (EffectShare& share : row.effects) {
        share.called_for /= static_cast<double>(count);
        share.acted /= static_cast<double>(count);
    }
    row.per_shot = price_of(shots, repeats);
    row.by_everything = price_by("everything", shots, repeats);
    return row;
}

}  // namespace poolhall::lab
