#pragma once

#include "shared/fields.hpp"
#include "shared/physics/check.hpp"
#include "shared/physics/scene/scene.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

// Every single number, name and choice of a scene, found by the lists of fields: for tests that
// hold for each, also for those of a struct that is added one day.
namespace poolhall::testing {

/// A scene in which nothing is absent and every effect is called for, so that it has every leaf.
inline Scene whole_scene() {
    Scene scene;
    scene.id = "whole";
    scene.table.pockets = PocketModel::kCircles;
    scene.table.mouths.emplace();
    scene.table.nose_height = 0.02;
    scene.effects.rail.nose_height = 0.02;
    scene.table.circles = {{"NE", {1.27, 0.635}, 0.1}, {"S", {0, -0.635}, 0.09}};
    for_each_field(scene.effects, [](const auto&, auto& effect) {
        if constexpr (requires { effect.emplace(); }) effect.emplace();
    });
    scene.effects.ball_ball.friction_by_speed.emplace();
    scene.effects.rail.e_by_speed.emplace();
    scene.balls = {{"cue", {{-0.5, 0.1, 0}, {1, 2, 0}, {4, 5, 6}}, 0.03, 0.2},
                   {"8", {{0.5, -0.1, 0}, {-1, -2, 0}, {-4, -5, -6}}, 0.02, 0.1}};
    scene.strike = Strike{BallIndex{0}, {0.6, 0.7}, 3, {0.1, 0.2}, 0.3, 0.04, CueSpec{}};
    return scene;
}

/// Walks over the leaves of a scene and changes the one of that number, in way `way` of several.
class LeafChanger {
  public:
    LeafChanger(std::size_t wanted, int way) : wanted_(wanted), way_(way) {}

    void walk(Scene& scene) { visit("", scene); }

    /// Of the leaf that was changed: "/balls/1/r/0"; empty where there are not so many.
    [[nodiscard]] const std::string& pointer() const { return pointer_; }

  private:
    static constexpr std::size_t kDone = static_cast<std::size_t>(-1);

    bool is_wanted(const std::string& pointer) {
        if (wanted_ == kDone) return false;
        if (wanted_-- > 0) return false;
        pointer_ = pointer;
        wanted_ = kDone;
        return true;
    }

    void visit(const std::string& pointer, Real& x) {
        const Real nudges[] = {1e-4 * x, -1e-4 * x, 1e-3, -1e-3};
        if (is_wanted(pointer)) x += nudges[way_ % 4];
    }

    void visit(const std::string& pointer, bool& x) {
        if (is_wanted(pointer)) x = !x;
    }

    void visit(const std::string& pointer, std::uint32_t& x) {
        if (is_wanted(pointer)) ++x;
    }

    void visit(const std::string& pointer, BallIndex& x) {
        if (is_wanted(pointer)) x.value = x.value == 0 ? 1 : 0;
    }

    void visit(const std::string& pointer, std::string& x) {
        if (is_wanted(pointer)) x += "x";
    }

    template <NamedEnum E>
    void visit(const std::string& pointer, E& x) {
        const auto step = 1 + static_cast<std::size_t>(way_);
        if (is_wanted(pointer)) x = kValues<E>[(static_cast<std::size_t>(x) + step) % kCount<E>];
    }

    void visit(const std::string& pointer, Vec2& a) {
        visit(pointer + "/0", a.x);
        visit(pointer + "/1", a.y);
    }

    void visit(const std::string& pointer, Vec3& a) {
        visit(pointer + "/0", a.x);
        visit(pointer + "/1", a.y);
        visit(pointer + "/2", a.z);
    }

    template <class T>
    void visit(const std::string& pointer, std::optional<T>& x) {
        if (!x) return;
        visit(pointer, *x);
        if (is_wanted(pointer)) x.reset();
    }

    template <class T>
    void visit(const std::string& pointer, std::vector<T>& all) {
        for (std::size_t i = 0; i < all.size(); ++i)
            visit(pointer + "/" + std::to_string(i), all[i]);
        if (is_wanted(pointer)) all.pop_back();
    }

    template <HasFieldList T>
    void visit(const std::string& pointer, T& object) {
        for_each_field(object, [&](const auto& field, auto& member) {
            visit(pointer + "/" + std::string(field.name), member);
        });
    }

    std::size_t wanted_;
    int way_;
    std::string pointer_;
};

/// Calls visit(pointer, scene) with the whole scene changed in one leaf, for every leaf; in a way
/// that check() lets pass.
inline void for_each_changed_leaf(
    const std::function<void(const std::string&, const Scene&)>& visit) {
    constexpr int kWays = 8;
    for (std::size_t leaf = 0;; ++leaf) {
        std::string pointer;
        for (int way = 0; way < kWays; ++way) {
            Scene scene = whole_scene();
            LeafChanger changer(leaf, way);
            changer.walk(scene);
            if (changer.pointer().empty()) return;
            // Circles go with the model that has them.
            if (scene.table.pockets != PocketModel::kCircles) scene.table.circles.clear();
            if (scene == whole_scene() || check(scene)) continue;
            pointer = changer.pointer();
            visit(pointer, scene);
            break;
        }
        if (pointer.empty()) visit("no good change of leaf " + std::to_string(leaf), Scene{});
    }
}

}  // namespace poolhall::testing
