#pragma once

#include "server/room/room.hpp"
#include "shared/result.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace poolhall::server {

struct LobbyServices {
    ReplayStore& store;
    Shards& shards;  ///< whose loops matches are dealt out to in turn
    Counters& counters;
    RoomLimits limits;
    std::size_t max_matches = 10000;
};

/// The open matches by their join codes. Safe from any thread; its lock is taken when somebody
/// comes or a match begins or ends, never in a tick.
class Lobby {
  public:
    explicit Lobby(LobbyServices services);

    /// Puts a match that was rebuilt from its log back.
    void reopen(Table table);
    /// Brings a member that is in no match to the one that it asks for, or refuses it.
    void enter(Request request, const protocol::EntryCommand& command);
    /// Takes no new matches any more.
    void close();
    /// Closes what has been left alone for too long.
    void sweep();

    [[nodiscard]] std::vector<MatchSummary> list() const;
    [[nodiscard]] std::size_t size() const;

  private:
    using FoundRoom = Result<std::shared_ptr<Room>, Refusal>;

    [[nodiscard]] FoundRoom room_for(const protocol::CreateMatch& command);

    /// All others name the match that they are for.
    template <class Entry>
    [[nodiscard]] FoundRoom room_for(const Entry& command) const {
        return find(command.code);
    }

    [[nodiscard]] FoundRoom find(const std::string& code) const;
    std::shared_ptr<Room> add(Table table);
    [[nodiscard]] std::vector<std::shared_ptr<Room>> rooms() const;

    LobbyServices services_;
    RoomServices room_services_;
    mutable std::mutex mutex_;  // guards what follows
    std::map<std::string, std::shared_ptr<Room>> rooms_;
    std::uint32_t next_shard_ = 0;
    bool closed_ = false;
};

}  // namespace poolhall::server
