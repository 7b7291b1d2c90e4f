#include "shared/analysis/effect_use.hpp"

#include <algorithm>
#include <array>
#include <type_traits>
#include <utility>

namespace poolhall::analysis {

namespace {

/// Whether the event shows that the effect acts; one that says nothing of it always does.
template <class Effect>
bool acts_on(const Scene& scene, const ShotEvent& event) {
    if constexpr (requires { Effect::acts_in(event.kind); }) {
        return Effect::acts_in(event.kind);
    } else if constexpr (requires { Effect::acts_on(scene, event.before[0], Real{}); }) {
        const auto shows = [&](std::size_t k) {
            const Real radius = radius_of(scene, scene.balls[event.balls[k].value]);
            return Effect::acts_on(scene, event.before[k], radius) ||
                   Effect::acts_on(scene, event.after[k], radius);
        };
        return shows(0) || (event.ball_count == 2 && shows(1));
    } else {
        return true;
    }
}

/// What people at a table call it.
std::string_view word_for(std::string_view effect) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 6> kWords{{
        {"linear_drag", "drag"},
        {"spin_decay", "spin"},
        {"airborne", "jump"},
        {"end_game_pockets", "pockets"},
        {"pocket_circles", "pockets"},
        {"pool_mouths", "rails and pockets"},
    }};
    const auto* const found = std::find_if(kWords.begin(), kWords.end(),
                                           [&](const auto& word) { return word.first == effect; });
    return found == kWords.end() ? effect : found->second;
}

std::string_view reason_of(Bound bound) {
    switch (bound) {
        case Bound::kNothingMoves:
            return "nothing moves";
        case Bound::kLevelCue:
            return "level cue";
        case Bound::kNoSideSpin:
            return "nothing makes any";
        case Bound::kNoMeeting:
            return "no two balls meet";
        case Bound::kOutOfReach:
            return "no ball reaches one";
    }
    return "";
}

void append(std::string& list, const std::string& item) {
    list += (list.empty() ? "" : ", ") + item;
}

}  // namespace

std::vector<EffectUse> effect_uses(const Scene& scene, const ShotTrace& trace) {
    std::vector<EffectUse> uses;
    trace.effects.for_each(
        [&]<class Effect>(std::type_identity<Effect>, std::optional<Bound> bound) {
            const bool acted = !bound && std::any_of(trace.events.begin(), trace.events.end(),
                                                     [&](const ShotEvent& event) {
                                                         return acts_on<Effect>(scene, event);
                                                     });
            uses.push_back({std::string(Effect::kName), bound, acted});
        });
    return uses;
}

std::string in_words(const std::vector<EffectUse>& uses) {
    std::string called_for;
    std::string ruled_out;
    for (const EffectUse& use : uses) {
        const std::string word(word_for(use.effect));
        if (use.ruled_out) {
            append(ruled_out, word + " (" + std::string(reason_of(*use.ruled_out)) + ")");
        } else {
            append(called_for, use.acted ? word : word + " (idle)");
        }
    }
    if (uses.empty()) return "";
    std::string words = "called for: " + (called_for.empty() ? "nothing" : called_for);
    if (!ruled_out.empty()) words += ". Ruled out: " + ruled_out;
    return words;
}

}  // namespace poolhall::analysis
