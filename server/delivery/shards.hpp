#pragma once

#include "server/delivery/member.hpp"
#include "server/delivery/outlet.hpp"
#include "server/net/loop.hpp"

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <vector>

namespace poolhall::server {

/// A loop and the outlets of the connections that live on it. All but id() and loop() is for the
/// loop's own thread.
class Shard {
  public:
    explicit Shard(ShardId id) : id_(id) {}

    [[nodiscard]] ShardId id() const { return id_; }

    [[nodiscard]] Loop& loop() { return loop_; }

    /// The outlet stays its connection's own.
    void add(MemberId member, std::weak_ptr<Outlet> outlet);
    void remove(MemberId member);
    /// Null if the connection is gone.
    [[nodiscard]] std::shared_ptr<Outlet> find(MemberId member) const;
    void each(const std::function<void(Outlet&)>& act) const;

  private:
    ShardId id_;
    Loop loop_;
    std::map<MemberId, std::weak_ptr<Outlet>> outlets_;
};

/// All loops that connections live on. Safe from any thread.
class Shards {
  public:
    explicit Shards(std::size_t count);

    [[nodiscard]] std::size_t size() const { return shards_.size(); }

    [[nodiscard]] Shard& at(ShardId id) { return *shards_.at(id.value); }

    [[nodiscard]] std::vector<Loop*> loops();

    /// Does something with the member's outlet, on its loop, unless the connection is gone.
    void post(const Member& member, std::function<void(Outlet&)> act);
    /// Sends one message to one connection.
    void send(const Member& member, const protocol::ServerMessage& message);
    /// Does something with every outlet, each on its loop.
    void post_to_all(const std::function<void(Outlet&)>& act);

    void start();
    void stop();
    /// On stopped loops: runs what is ready, on the calling thread; false if nothing was.
    bool run_ready();

  private:
    std::vector<std::unique_ptr<Shard>> shards_;
};

}  // namespace poolhall::server
