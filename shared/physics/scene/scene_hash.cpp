#include "shared/math/state_hash.hpp"
#include "shared/physics/scene/scene.hpp"

// The scene's hash follows the lists of fields. Four things are as they have always been, so that
// the hashes of old scenes stay: see the comments below.
namespace poolhall {

namespace {

class SceneHash {
  public:
    explicit SceneHash(const Scene& scene) : scene_(scene) {}

    std::uint64_t value() {
        for_each_field(scene_, [this](const auto& field, const auto& member) {
            // Its name moves no ball.
            if (field.name != "id") this->add(member);
        });
        return hash_.value();
    }

  private:
    void add(Real x) { hash_.add(x); }

    void add(const Vec3& a) { hash_.add(a); }

    void add(Vec2 a) {
        add(a.x);
        add(a.y);
    }

    void add(BallIndex index) { hash_.add(std::uint64_t{index.value}); }

    template <class T>
    requires std::is_integral_v<T> || std::is_enum_v<T>

    void add(T x) { hash_.add(static_cast<std::uint64_t>(x)); }

    void add(std::string_view text) {
        hash_.add(std::uint64_t{text.size()});
        for (const char c : text)
            hash_.add(std::uint64_t{static_cast<unsigned char>(c)});
    }

    void add(const std::string& text) { add(std::string_view(text)); }

    template <class T>
    void add(const std::optional<T>& x) {
        add(x.has_value());
        if (x) add(*x);
    }

    template <class T>
    void add(const std::vector<T>& all) {
        for (const T& x : all)
            add(x);
    }

    template <HasFieldList T>
    void add(const T& object) {
        for_each_field(object, [this](const auto& field, const auto& member) {
            this->add_field(field, member);
        });
    }

    void add_field(const auto& /*field*/, const auto& member) { add(member); }

    template <class T>
    void add_field(const auto& field, const std::optional<T>& x) {
        if (field.hashed_where_set) {
            add_if_there(field, x);
        } else {
            add(x);
        }
    }

    template <class T>
    void add_if_there(const auto& field, const std::optional<T>& x) {
        if (!x) return;
        add(field.name);
        add(*x);
    }

    void add(const Effects& effects) {
        for_each_field(effects, [this](const auto& field, const auto& effect) {
            this->add_effect(field, effect);
        });
    }

    template <HasFieldList Spec>
    void add_effect(const auto& /*field*/, const Spec& spec) {
        add(spec);
    }

    /// The first effects have a word before each of their parameters that says whether they are
    /// there. Others enter by their names where they are there, and leave alone the hashes of
    /// scenes without them.
    template <class Spec>
    void add_effect(const auto& field, const std::optional<Spec>& spec) {
        if (!field.absence_enters_the_hash) {
            add_if_there(field, spec);
            return;
        }
        const Spec none;
        for_each_field(spec ? *spec : none, [&](const auto&, const auto& parameter) {
            add(spec.has_value());
            if (spec) add(parameter);
        });
    }

    /// By the size that the ball has, whether its own or that of all.
    void add(const SceneBall& ball) {
        SceneBall sized = ball;
        sized.radius = radius_of(scene_, ball);
        sized.mass = mass_of(scene_, ball);
        for_each_field(sized, [this](const auto&, const auto& member) {
            if constexpr (requires { *member; }) {
                this->add(*member);
            } else {
                this->add(member);
            }
        });
    }

    /// By a direction in space.
    void add(const Strike& strike) {
        for_each_field(strike, [this](const auto& field, const auto& member) {
            this->add_field(field, member);
            if (field.name == "direction") add(Real{0});
        });
    }

    const Scene& scene_;
    StateHash hash_;
};

}  // namespace

std::uint64_t hash_of(const Scene& scene) {
    return SceneHash(scene).value();
}

}  // namespace poolhall
