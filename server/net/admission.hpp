#pragma once

#include "server/base/counters.hpp"

#include <chrono>
#include <cstddef>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <utility>

namespace boost::asio::ip {
class address;
}

namespace poolhall::server {

struct AdmissionLimits {
    std::size_t total = 0;        ///< connections
    std::size_t per_address = 0;  ///< connections of one address, or of one IPv6 /64; 0: no bound
};

/// Who may be connected, so that nobody keeps the others out: where there is no place left, a
/// newcomer takes that of a connection which has asked for nothing yet. Of an address that has all
/// it may have it is the oldest of its own; where the server is full, the oldest of the address
/// that has most of them. Who finds none is refused, but for connections from this machine: a few
/// of them are let in beyond all bounds, for health checks. Safe to use from any thread.
class Admission {
  public:
    class Place;

    /// `counters` must outlive this.
    Admission(AdmissionLimits limits, Counters& counters);

    /// A place for a connection that has asked for nothing yet; nothing if there is none.
    /// Places must be gone before this is.
    [[nodiscard]] std::shared_ptr<Place> admit(const boost::asio::ip::address& peer);

  private:
    struct Group {
        std::string name;
        std::size_t places = 0;
        std::list<Place*> silent;  ///< oldest first
    };

    using Close = std::function<void()>;

    Group* make_room(Group& own, bool local, Close& close);
    Close evict(Place& place);
    Group* most_silent();
    void enter(Group& group);
    void leave(Group& group);
    void set_silent(Place& place, bool silent);
    void complain(const Group& group);

    AdmissionLimits limits_;
    Counters& counters_;
    std::mutex mutex_;                     ///< guards all that follows, and what places hold
    std::map<std::string, Group> groups_;  ///< by admission_group()
    Group reserve_;                        ///< beyond the bounds, for this machine
    std::size_t total_ = 0;
    /// How many silent places each address has that has any.
    std::set<std::pair<std::size_t, Group*>> silence_;
    std::chrono::steady_clock::time_point complained_{};
};

/// Held for as long as the connection lasts.
class Admission::Place {
  public:
    Place(Admission& admission, Group& group, bool reserved)
        : admission_(admission), group_(&group), reserved_(reserved) {}

    ~Place();
    Place(const Place&) = delete;
    Place& operator=(const Place&) = delete;
    Place(Place&&) = delete;
    Place& operator=(Place&&) = delete;

    /// From now on the connection waits for a request: `close` may be called, once, from any
    /// thread, even after this is gone. False if the place has been given away already.
    [[nodiscard]] bool wait(Close close);
    /// The connection has been asked for something. False if the place has been given away.
    [[nodiscard]] bool work();

    /// Beyond the bounds: for health checks only.
    [[nodiscard]] bool is_reserved() const { return reserved_; }

  private:
    friend class Admission;

    Admission& admission_;
    Group* group_;  ///< nullptr once it has been given away
    bool reserved_;
    Close close_;
    bool silent_ = false;
    std::list<Place*>::iterator at_;  ///< in the group's silent ones, while it is
};

/// How addresses are told apart: IPv4 whole, IPv6 by its /64.
[[nodiscard]] std::string admission_group(const boost::asio::ip::address& peer);

}  // namespace poolhall::server
