#pragma once

#include "protocol/messages.hpp"
#include "server/base/secret.hpp"
#include "server/room/playout.hpp"
#include "shared/game/ruleset.hpp"
#include "shared/game/settings.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace poolhall::server {

/// A connection that follows a match. Numbers are not used twice while the server runs.
struct MemberId {
    std::uint64_t value = 0;

    friend constexpr auto operator<=>(const MemberId&, const MemberId&) = default;
};

struct SeatHolder {
    std::string name;
    TokenHash token;                 ///< brings the holder back
    std::optional<MemberId> member;  ///< the holder's connection; none while away
};

struct MatchSpec {
    std::string id;
    std::string code;
    const Ruleset* rules = nullptr;
    Seat first;               ///< breaks in the first game
    GameSettings settings{};  ///< of all its games; must have passed the rules' check()
};

/// One table: who sits at it, who watches, and the game. Sole owner of all that.
///
/// The pure core: it knows no socket, thread, clock or store. Its preconditions are what check()
/// in gate.hpp answers; nothing that fails there may be asked of it.
class Match {
  public:
    explicit Match(MatchSpec spec);

    [[nodiscard]] const std::string& id() const { return spec_.id; }

    [[nodiscard]] const std::string& code() const { return spec_.code; }

    [[nodiscard]] const Ruleset& rules() const { return *spec_.rules; }

    [[nodiscard]] const GameSettings& settings() const { return spec_.settings; }

    // ---- people
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

    /// Takes an open seat; whoever of its holder was watching no longer is.
    void take_seat(Seat seat, SeatHolder holder);
    /// Opens the seat; a member who then holds none goes on as a spectator.
    void leave_seat(Seat seat);
    void watch(MemberId member, std::string name);
    /// The member goes for good: its seats open.
    void leave(MemberId member);
    /// The connection is gone: the seats stay reserved for the token.
    void disconnect(MemberId member);
    /// `member` takes over all seats of the token; returns the connection it replaces.
    std::optional<MemberId> resume(const TokenHash& token, MemberId member);

    // ---- the game
    [[nodiscard]] protocol::Phase phase() const;

    /// Everything at rest; while a shot runs, as before it.
    [[nodiscard]] const GameState& game() const { return game_; }

    [[nodiscard]] std::uint32_t game_number() const { return game_number_; }

    [[nodiscard]] std::uint32_t shots() const { return shots_; }

    /// Who breaks in the game after this one.
    [[nodiscard]] Seat next_first() const { return opponent(first_); }

    [[nodiscard]] Vec2 aim() const { return aim_; }

    [[nodiscard]] Vec2 cue_ball() const;

    [[nodiscard]] bool wants_rematch(Seat seat) const { return rematch_[seat.value]; }

    /// The shot that runs, if one does.
    [[nodiscard]] const std::optional<Playout>& playout() const { return playout_; }

    [[nodiscard]] protocol::TableState table() const;

    void set_aim(Vec2 direction) { aim_ = direction; }

    /// Moves the cue ball; the aim turns to where the rules point it.
    void place_cue_ball(Vec2 position);
    /// Begins to show a shot that the rules have played from game(), for that much CPU time.
    void start_shot(ShotOutcome outcome, std::chrono::nanoseconds cpu);

    [[nodiscard]] protocol::Frame advance(std::uint32_t tick) { return playout_->advance(tick); }

    /// Ends the running shot: its result becomes the game's state.
    protocol::ShotEnded finish_shot();

    void vote_rematch(Seat seat) { rematch_[seat.value] = true; }

    /// Begins the next game, broken by next_first().
    void start_next_game();

  private:
    [[nodiscard]] std::optional<SeatHolder>& seat_at(Seat seat) { return seats_[seat.value]; }

    [[nodiscard]] protocol::SeatInfo seat_info(Seat seat) const;
    void begin_game(Seat first);

    MatchSpec spec_;
    std::array<std::optional<SeatHolder>, kSeatCount> seats_;
    std::array<std::uint32_t, kSeatCount> wins_{};
    std::array<bool, kSeatCount> rematch_{};
    std::map<MemberId, std::string> spectators_;  ///< and their names
    GameState game_;
    Seat first_;
    std::uint32_t game_number_ = 1;
    std::uint32_t shots_ = 0;
    Vec2 aim_;
    std::optional<Ruling> ruling_;  ///< of the last shot of this game
    std::optional<Playout> playout_;
};

inline constexpr std::array<Seat, kSeatCount> kSeats{Seat{0}, Seat{1}};

}  // namespace poolhall::server
