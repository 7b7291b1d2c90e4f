#include "shared/game/game_state.hpp"

#include "shared/math/state_hash.hpp"

namespace poolhall {

namespace {

class GameHash {
  public:
    template <HasFieldList T>
    void add_fields(const T& object) {
        for_each_field(object, [this](const auto&, const auto& member) { add(member); });
    }

    [[nodiscard]] std::uint64_t value() const { return hash_.value(); }

  private:
    void add(const Scene& scene) { hash_.add(hash_of(scene)); }

    void add(BallIndex ball) { hash_.add(std::uint64_t{ball.value}); }

    void add(Seat seat) { hash_.add(std::uint64_t{seat.value}); }

    void add(std::uint32_t number) { hash_.add(std::uint64_t{number}); }

    void add(bool flag) { hash_.add(std::uint64_t{flag}); }

    template <class T>
    void add(const std::optional<T>& member) {
        add(member.has_value());
        if (member) add(*member);
    }

    /// By its place among the games: new ones go to the end.
    void add(const GamePart& part) {
        hash_.add(std::uint64_t{part.index()});
        std::visit([this](const auto& fields) { add_fields(fields); }, part);
    }

    StateHash hash_;
};

}  // namespace

std::uint64_t hash_of(const GameState& state) {
    GameHash hash;
    hash.add_fields(state);
    return hash.value();
}

}  // namespace poolhall
