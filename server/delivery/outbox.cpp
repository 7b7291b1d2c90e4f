#include "server/delivery/outbox.hpp"

#include "server/delivery/merge_frames.hpp"

#include <algorithm>
#include <utility>
#include <variant>

namespace poolhall::server {
namespace {

using protocol::AimChanged;
using protocol::Frame;
using protocol::ServerMessage;
using protocol::ShotEnded;
using protocol::ShotStarted;
using protocol::TableChanged;

template <class T>
const T* as(const Parcel& parcel) {
    return std::get_if<T>(parcel.message.get());
}

}  // namespace

bool Outbox::push(Parcel parcel, Clock::time_point now) {
    if (waiting_.size() >= kBacklog) {
        if (!behind_since_) behind_since_ = now;
        if (merge_frame(parcel)) return true;
        drop_older(parcel);
        if (as<ShotStarted>(parcel)) shrink_shot();
    }
    if (waiting_.size() >= kLimit) return false;
    waiting_.push_back(std::move(parcel));
    return true;
}

std::optional<Parcel> Outbox::pop() {
    if (waiting_.empty()) return std::nullopt;
    Parcel parcel = std::move(waiting_.front());
    waiting_.pop_front();
    if (waiting_.empty()) behind_since_.reset();
    return parcel;
}

void Outbox::clear() {
    waiting_.clear();
    behind_since_.reset();
}

/// Merges into the last frame that waits; what stands behind it (replies) does not depend on it.
bool Outbox::merge_frame(const Parcel& parcel) {
    const auto* newer = as<Frame>(parcel);
    if (!newer) return false;
    const auto last = std::find_if(waiting_.rbegin(), waiting_.rend(),
                                   [](const Parcel& p) { return as<Frame>(p); });
    if (last == waiting_.rend() || as<Frame>(*last)->shot != newer->shot) return false;
    *last = {std::make_shared<const ServerMessage>(merge(*as<Frame>(*last), *newer)), nullptr};
    return true;
}

/// An aim or a table says all that an earlier one said.
void Outbox::drop_older(const Parcel& parcel) {
    const bool table = as<TableChanged>(parcel) != nullptr;
    if (!table && !as<AimChanged>(parcel)) return;
    std::erase_if(waiting_, [table](const Parcel& p) {
        return as<AimChanged>(p) || (table && as<TableChanged>(p));
    });
}

/// Drops the last whole shot that waits, and all before it that only shows the game, but for the
/// table that it led to.
void Outbox::shrink_shot() {
    const auto end = std::find_if(waiting_.rbegin(), waiting_.rend(),
                                  [](const Parcel& p) { return as<ShotEnded>(p); });
    if (end == waiting_.rend()) return;
    const auto index = static_cast<std::size_t>(waiting_.rend() - end) - 1;
    *end = {std::make_shared<const ServerMessage>(TableChanged{as<ShotEnded>(*end)->table}),
            nullptr};
    std::deque<Parcel> kept;
    for (std::size_t i = 0; i < waiting_.size(); ++i) {
        const Parcel& parcel = waiting_[i];
        const bool shows = as<Frame>(parcel) || as<ShotStarted>(parcel) || as<ShotEnded>(parcel) ||
                           as<AimChanged>(parcel) || as<TableChanged>(parcel);
        if (i >= index || !shows) kept.push_back(parcel);
    }
    waiting_ = std::move(kept);
}

}  // namespace poolhall::server
