#include "server/delivery/fan_out.hpp"

#include "protocol/codec/codec.hpp"

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

struct FanOut::Broadcast {
    std::shared_ptr<const ServerMessage> message;
    PerEncoding<std::shared_ptr<const std::string>> bytes;
    Streams streams{};
};

struct FanOut::Audience {
    struct Listener {
        MemberId id;
        Encoding encoding = Encoding::kJson;
        Stream stream = Stream::kStates;
    };

    std::vector<Listener> listeners;

    void hear(const Shard& shard, const Broadcast& broadcast) const {
        for (const Listener& listener : listeners) {
            if (!broadcast.streams[index(listener.stream)]) continue;
            if (const auto outlet = shard.find(listener.id))
                outlet->push({broadcast.message, broadcast.bytes[index(listener.encoding)]});
        }
    }
};

void FanOut::add(const Member& member, Stream stream) {
    followers_[member.id] = {member, stream};
    ++counts_[index(stream)][index(member.encoding)];
    Branch& branch = branch_of(member.shard);
    ++branch.followers;
    shards_.at(member.shard).loop().post([audience = branch.audience, member, stream] {
        audience->listeners.push_back({member.id, member.encoding, stream});
    });
}

void FanOut::remove(MemberId member) {
    const auto found = followers_.find(member);
    if (found == followers_.end()) return;
    const Member address = found->second.member;
    --counts_[index(found->second.stream)][index(address.encoding)];
    Branch& branch = branch_of(address.shard);
    shards_.at(address.shard).loop().post([audience = branch.audience, member] {
        std::erase_if(audience->listeners,
                      [member](const auto& listener) { return listener.id == member; });
    });
    if (--branch.followers == 0)
        std::erase_if(branches_, [&](const Branch& other) { return other.shard == address.shard; });
    followers_.erase(found);
}

FanOut::Branch& FanOut::branch_of(ShardId shard) {
    const auto found = std::find_if(branches_.begin(), branches_.end(),
                                    [&](const Branch& branch) { return branch.shard == shard; });
    if (found != branches_.end()) return *found;
    return branches_.emplace_back(Branch{shard, std::make_shared<Audience>(), 0});
}

const Member* FanOut::find(MemberId member) const {
    const auto found = followers_.find(member);
    return found == followers_.end() ? nullptr : &found->second.member;
}

void FanOut::send(const ServerMessage& message) {
    Streams all{};
    all.fill(true);
    send(message, all);
}

void FanOut::send(const ServerMessage& message, Stream stream) {
    Streams one{};
    one[index(stream)] = true;
    send(message, one);
}

bool FanOut::is_wanted(Encoding encoding, const Streams& streams) const {
    return std::any_of(kValues<Stream>.begin(), kValues<Stream>.end(), [&](Stream stream) {
        return streams[index(stream)] && counts_[index(stream)][index(encoding)] > 0;
    });
}

void FanOut::send(const ServerMessage& message, const Streams& streams) {
    Broadcast broadcast{nullptr, {}, streams};
    for (const Encoding encoding : kValues<Encoding>) {
        if (!is_wanted(encoding, streams)) continue;
        if (!broadcast.message) broadcast.message = std::make_shared<const ServerMessage>(message);
        broadcast.bytes[index(encoding)] =
            std::make_shared<const std::string>(encode(message, encoding));
    }
    if (broadcast.message) post(std::make_shared<const Broadcast>(std::move(broadcast)));
}

void FanOut::post(const std::shared_ptr<const Broadcast>& broadcast) {
    for (const Branch& branch : branches_) {
        Shard& shard = shards_.at(branch.shard);
        shard.loop().post(
            [&shard, audience = branch.audience, broadcast] { audience->hear(shard, *broadcast); });
    }
}

}  // namespace poolhall::server
