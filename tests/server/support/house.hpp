#pragma once

#include "server/room/lobby.hpp"
#include "tests/server/support/temp_folder.hpp"

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace poolhall::server::test {

/// Rooms, lobby and store without sockets. Their loops run on the test's own thread, and only when
/// it asks for it.
class House {
  public:
    explicit House(RoomLimits limits = {}, std::size_t max_matches = 10, std::size_t loops = 1);
    ~House();
    House(const House&) = delete;
    House& operator=(const House&) = delete;

    [[nodiscard]] Lobby& lobby() { return *lobby_; }

    [[nodiscard]] Shards& shards() { return shards_; }

    [[nodiscard]] Counters& counters() { return counters_; }

    /// Runs all that is ready, and what comes of it.
    void settle();

    /// Runs what is ready, as time goes on, until `done`; false if that takes longer than 10 s.
    template <class Done>
    [[nodiscard]] bool run_until(Done done) {
        const auto end = LoopTimer::Clock::now() + std::chrono::seconds(10);
        for (settle(); !done(); wait_and_settle())
            if (LoopTimer::Clock::now() > end) return false;
        return true;
    }

    /// Runs for that long.
    void run_for(std::chrono::milliseconds time);

    /// Does what is ready and makes it durable, but nothing that waits for it to be so.
    void run_to_the_store();
    /// The only open match as a server that starts now would find it.
    [[nodiscard]] StoredMatch stored();

    [[nodiscard]] MemberId next_member() { return {++last_member_}; }

  private:
    void wait_and_settle();

    TempFolder folder_;
    Counters counters_;
    Shards shards_;
    std::unique_ptr<ReplayStore> store_;
    std::unique_ptr<Lobby> lobby_;
    std::uint64_t last_member_ = 0;
};

/// Keeps what it gets.
class FakeOutlet final : public Outlet {
  public:
    void push(Parcel parcel) override { got.push_back(*parcel.message); }

    void close(CloseReason reason, const std::string&) override { closed = reason; }

    void abort() override {}

    std::vector<protocol::ServerMessage> got;
    std::optional<CloseReason> closed;
};

/// A connection as a session makes it, without a socket.
class Guest {
  public:
    explicit Guest(House& house);
    ~Guest();
    Guest(const Guest&) = delete;
    Guest& operator=(const Guest&) = delete;

    /// Sends a command, and no more.
    void send(const protocol::ClientBody& command);
    /// Sends a command and runs until all is quiet; why it was rejected, if it was.
    std::optional<protocol::Reject> ask(const protocol::ClientBody& command);
    /// The same as the reject's code, "" if it was accepted.
    std::string code_of(const protocol::ClientBody& command);
    /// Comes into the match and is answered `joined`.
    protocol::Joined enter(const protocol::EntryCommand& command);
    /// The connection is gone.
    void disconnect();

    [[nodiscard]] const Standing& standing() const { return standing_; }

    [[nodiscard]] bool is_closed() const { return outlet_->closed.has_value(); }

    /// The newest message of its kind; null if there was none.
    template <class T>
    [[nodiscard]] const T* newest() const {
        const auto& got = outlet_->got;
        for (auto message = got.rbegin(); message != got.rend(); ++message)
            if (const auto* found = std::get_if<T>(&*message)) return found;
        return nullptr;
    }

    /// The newest state of the table that it was told.
    [[nodiscard]] const protocol::TableState& table() const;

  private:
    [[nodiscard]] Request next_request();

    House& house_;
    Member member_;
    std::shared_ptr<FakeOutlet> outlet_ = std::make_shared<FakeOutlet>();
    Standing standing_;
    std::uint32_t seq_ = 0;
};

/// Ada in seat 0 and Ben in seat 1 of a new match.
struct Duel {
    explicit Duel(House& house, std::optional<MatchSettings> settings = {});

    [[nodiscard]] Guest& player(Seat seat) { return seat == Seat{0} ? ada : ben; }

    Guest ada;
    Guest ben;
    protocol::Joined adas;
    protocol::Joined bens;
};

[[nodiscard]] inline protocol::MakeMove shoot(Seat seat, Vec2 direction) {
    return {seat, Shoot{Stroke{direction, {}}}};
}

}  // namespace poolhall::server::test
