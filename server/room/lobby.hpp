#pragma once

#include "server/room/room.hpp"

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace poolhall::server {

struct LobbyServices {
    ReplayStore& store;
    Counters& counters;
    RoomLimits limits;
    std::size_t max_matches = 10000;
    std::vector<Loop*> loops;  ///< matches are dealt out to these in turn
};

/// The open matches by their join codes. Safe from any thread; its lock is taken when somebody
/// comes or a match begins or ends, never in a tick.
class Lobby {
  public:
    explicit Lobby(LobbyServices services);

    /// Puts a match that was rebuilt from its log back.
    void reopen(Match match);
    /// Brings a command to where it belongs: to `current`, the member's match, or to the match that
    /// it asks for. Answers at once what no match has to be asked for.
    void submit(const std::shared_ptr<Room>& current, Request request);
    /// Takes no new matches any more.
    void close();
    /// Closes what has been left alone for too long.
    void sweep();

    [[nodiscard]] std::vector<MatchSummary> list() const;
    [[nodiscard]] std::size_t size() const;

  private:
    [[nodiscard]] std::shared_ptr<Room> find(const std::string& code) const;
    void enter(const std::string& code, Request request);
    void create(const protocol::CreateMatch& command, Request request);
    std::shared_ptr<Room> add(Match match);
    [[nodiscard]] std::vector<std::shared_ptr<Room>> rooms() const;
    void reject(const Request& request, Refusal refusal);

    LobbyServices services_;
    RoomServices room_services_;
    mutable std::mutex mutex_;  // guards what follows
    std::map<std::string, std::shared_ptr<Room>> rooms_;
    std::size_t next_loop_ = 0;
    bool closed_ = false;
};

}  // namespace poolhall::server
