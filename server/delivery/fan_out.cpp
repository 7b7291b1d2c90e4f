#include "server/delivery/fan_out.hpp"

#include "protocol/codec.hpp"

#include <algorithm>
#include <utility>

namespace poolhall::server {

using protocol::Encoding;
using protocol::ServerMessage;
using protocol::Stream;

namespace {

std::size_t index(Encoding encoding) {
    return static_cast<std::size_t>(encoding);
}

std::size_t index(Stream stream) {
    return static_cast<std::size_t>(stream);
}

}  // namespace

struct FanOut::Audience {
    struct Listener {
        MemberId id;
        std::shared_ptr<Outlet> outlet;
        Encoding encoding = Encoding::kJson;
        Stream stream = Stream::kStates;
    };

    std::vector<Listener> listeners;
};

struct FanOut::Broadcast {
    std::shared_ptr<const ServerMessage> message;
    std::array<std::shared_ptr<const std::string>, kEncodings> bytes;
    std::array<bool, kStreams> streams{};
};

void FanOut::add(const Member& member, Stream stream) {
    followers_[member.id] = {member, stream};
    ++counts_[index(stream)][index(member.encoding)];
    Branch& branch = branch_of(member.loop);
    ++branch.followers;
    branch.loop->post([audience = branch.audience, member, stream] {
        audience->listeners.push_back({member.id, member.outlet, member.encoding, stream});
    });
}

void FanOut::remove(MemberId member) {
    const auto found = followers_.find(member);
    if (found == followers_.end()) return;
    const Follower& follower = found->second;
    --counts_[index(follower.stream)][index(follower.member.encoding)];
    Branch& branch = branch_of(follower.member.loop);
    branch.loop->post([audience = branch.audience, member] {
        std::erase_if(audience->listeners,
                      [member](const auto& listener) { return listener.id == member; });
    });
    if (--branch.followers == 0)
        std::erase_if(branches_,
                      [&](const Branch& other) { return other.loop == follower.member.loop; });
    followers_.erase(found);
}

FanOut::Branch& FanOut::branch_of(Loop* loop) {
    const auto found = std::find_if(branches_.begin(), branches_.end(),
                                    [&](const Branch& branch) { return branch.loop == loop; });
    if (found != branches_.end()) return *found;
    return branches_.emplace_back(Branch{loop, std::make_shared<Audience>(), 0});
}

const Member* FanOut::find(MemberId member) const {
    const auto found = followers_.find(member);
    return found == followers_.end() ? nullptr : &found->second.member;
}

void FanOut::send(const ServerMessage& message) {
    broadcast(message, {true, true});
}

void FanOut::send(const ServerMessage& message, Stream stream) {
    std::array<bool, kStreams> streams{};
    streams[index(stream)] = true;
    broadcast(message, streams);
}

void FanOut::broadcast(const ServerMessage& message, const std::array<bool, kStreams>& streams) {
    auto broadcast = std::make_shared<Broadcast>();
    broadcast->streams = streams;
    bool wanted_at_all = false;
    for (const Encoding encoding : {Encoding::kJson, Encoding::kCbor}) {
        std::size_t wanted = 0;
        for (std::size_t stream = 0; stream < kStreams; ++stream)
            if (streams[stream]) wanted += counts_[stream][index(encoding)];
        if (wanted == 0) continue;
        wanted_at_all = true;
        broadcast->bytes[index(encoding)] =
            std::make_shared<const std::string>(encode(message, encoding));
    }
    if (!wanted_at_all) return;
    broadcast->message = std::make_shared<const ServerMessage>(message);
    for (const Branch& branch : branches_) {
        branch.loop->post([audience = branch.audience, broadcast] {
            for (const auto& listener : audience->listeners)
                if (broadcast->streams[index(listener.stream)])
                    listener.outlet->push(
                        {broadcast->message, broadcast->bytes[index(listener.encoding)]});
        });
    }
}

void FanOut::send(const Member& member, const ServerMessage& message) {
    Parcel parcel{std::make_shared<const ServerMessage>(message),
                  std::make_shared<const std::string>(encode(message, member.encoding))};
    member.loop->post(
        [outlet = member.outlet, parcel = std::move(parcel)] { outlet->push(parcel); });
}

}  // namespace poolhall::server
