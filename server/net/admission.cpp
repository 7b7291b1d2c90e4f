#include "server/net/admission.hpp"

#include <boost/asio/ip/address.hpp>

#include <algorithm>
#include <spdlog/spdlog.h>

namespace poolhall::server {
namespace {

namespace ip = boost::asio::ip;

constexpr std::size_t kReserve = 8;
constexpr auto kComplainEvery = std::chrono::seconds(10);

/// An IPv4 address that comes by a socket for both is IPv4.
ip::address plain(const ip::address& peer) {
    if (peer.is_v6() && peer.to_v6().is_v4_mapped())
        return ip::make_address_v4(ip::v4_mapped, peer.to_v6());
    return peer;
}

}  // namespace

std::string admission_group(const ip::address& peer) {
    const ip::address address = plain(peer);
    if (address.is_v4()) return address.to_string();
    auto bytes = address.to_v6().to_bytes();
    std::fill(bytes.begin() + 8, bytes.end(), std::uint8_t{0});
    return ip::address_v6(bytes).to_string() + "/64";
}

Admission::Admission(AdmissionLimits limits, Counters& counters)
    : limits_(limits), counters_(counters) {}

std::shared_ptr<Admission::Place> Admission::admit(const ip::address& peer) {
    const std::string name = admission_group(peer);
    Close close;
    std::shared_ptr<Place> place;
    {
        const std::lock_guard lock(mutex_);
        Group& own = groups_.try_emplace(name).first->second;
        own.name = name;
        enter(own);  // so that it stays while others leave it
        Group* const group = make_room(own, plain(peer).is_loopback(), close);
        if (group != &own) leave(own);
        if (group == nullptr) {
            counters_.connections_refused.fetch_add(1, std::memory_order_relaxed);
            return nullptr;
        }
        if (group != &own) enter(*group);
        place = std::make_shared<Place>(*this, *group, group == &reserve_);
        set_silent(*place, true);
    }
    if (close) close();
    return place;
}

/// The group that has a place for a newcomer who is counted in `own` already, after the connection
/// that `close` closes has lost its own; nullptr if there is none.
Admission::Group* Admission::make_room(Group& own, bool local, Close& close) {
    const bool own_full = limits_.per_address > 0 && own.places > limits_.per_address;
    if (!own_full && total_ <= limits_.total) return &own;
    Group* const crowd = own_full ? (own.silent.empty() ? nullptr : &own) : most_silent();
    complain(crowd != nullptr ? *crowd : own);
    if (crowd != nullptr) {
        close = evict(*crowd->silent.front());
        return &own;
    }
    if (!local) return nullptr;
    if (reserve_.places < kReserve) return &reserve_;
    if (reserve_.silent.empty()) return nullptr;
    close = evict(*reserve_.silent.front());
    return &reserve_;
}

/// Takes its place away; what closes the connection, or nothing if it will find out by itself.
Admission::Close Admission::evict(Place& place) {
    counters_.connections_evicted.fetch_add(1, std::memory_order_relaxed);
    set_silent(place, false);
    leave(*std::exchange(place.group_, nullptr));
    return std::exchange(place.close_, nullptr);
}

Admission::Group* Admission::most_silent() {
    return silence_.empty() ? nullptr : silence_.rbegin()->second;
}

void Admission::enter(Group& group) {
    ++group.places;
    if (&group != &reserve_) ++total_;
}

void Admission::leave(Group& group) {
    --group.places;
    if (&group == &reserve_) return;
    --total_;
    if (group.places == 0) groups_.erase(std::string(group.name));
}

void Admission::set_silent(Place& place, bool silent) {
    if (place.group_ == nullptr || place.silent_ == silent) return;
    Group& group = *place.group_;
    place.silent_ = silent;
    silence_.erase({group.silent.size(), &group});
    if (silent)
        place.at_ = group.silent.insert(group.silent.end(), &place);
    else
        group.silent.erase(place.at_);
    if (!group.silent.empty() && &group != &reserve_)
        silence_.insert({group.silent.size(), &group});
}

void Admission::complain(const Group& group) {
    const auto now = std::chrono::steady_clock::now();
    if (complained_ != decltype(complained_){} && now - complained_ < kComplainEvery) return;
    complained_ = now;
    spdlog::warn(
        "too many connections: {} of at most {}, {} of them from {} (max-per-address is {}), {} of "
        "which have asked for nothing and make room",
        total_, limits_.total, group.places, group.name, limits_.per_address, group.silent.size());
}

Admission::Place::~Place() {
    const std::lock_guard lock(admission_.mutex_);
    if (group_ == nullptr) return;
    admission_.set_silent(*this, false);
    admission_.leave(*group_);
}

bool Admission::Place::wait(Close close) {
    const std::lock_guard lock(admission_.mutex_);
    if (group_ == nullptr) return false;
    close_ = std::move(close);
    admission_.set_silent(*this, true);
    return true;
}

bool Admission::Place::work() {
    const std::lock_guard lock(admission_.mutex_);
    if (group_ == nullptr) return false;
    close_ = nullptr;
    admission_.set_silent(*this, false);
    return true;
}

}  // namespace poolhall::server
