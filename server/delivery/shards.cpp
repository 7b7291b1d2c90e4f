#include "server/delivery/shards.hpp"

#include "protocol/codec/codec.hpp"

#include <string>
#include <utility>

namespace poolhall::server {

void Shard::add(MemberId member, std::weak_ptr<Outlet> outlet) {
    outlets_[member] = std::move(outlet);
}

void Shard::remove(MemberId member) {
    outlets_.erase(member);
}

std::shared_ptr<Outlet> Shard::find(MemberId member) const {
    const auto found = outlets_.find(member);
    return found == outlets_.end() ? nullptr : found->second.lock();
}

void Shard::each(const std::function<void(Outlet&)>& act) const {
    // Copied: an outlet may leave while it is spoken to.
    const auto now = outlets_;
    for (const auto& [id, outlet] : now)
        if (const auto alive = outlet.lock()) act(*alive);
}

Shards::Shards(std::size_t count) {
    for (std::uint32_t i = 0; i < count; ++i)
        shards_.push_back(std::make_unique<Shard>(ShardId{i}));
}

std::vector<Loop*> Shards::loops() {
    std::vector<Loop*> loops;
    for (const auto& shard : shards_)
        loops.push_back(&shard->loop());
    return loops;
}

void Shards::post(const Member& member, std::function<void(Outlet&)> act) {
    Shard& shard = at(member.shard);
    shard.loop().post([&shard, id = member.id, act = std::move(act)] {
        if (const auto outlet = shard.find(id)) act(*outlet);
    });
}

void Shards::send(const Member& member, const protocol::ServerMessage& message) {
    Parcel parcel{std::make_shared<const protocol::ServerMessage>(message),
                  std::make_shared<const std::string>(encode(message, member.encoding))};
    post(member, [parcel = std::move(parcel)](Outlet& outlet) { outlet.push(parcel); });
}

void Shards::post_to_all(const std::function<void(Outlet&)>& act) {
    for (const auto& shard : shards_)
        shard->loop().post([&shard = *shard, act] { shard.each(act); });
}

void Shards::start() {
    for (const auto& shard : shards_)
        shard->loop().start();
}

void Shards::stop() {
    for (const auto& shard : shards_)
        shard->loop().stop();
}

bool Shards::run_ready() {
    bool ran = false;
    for (const auto& shard : shards_)
        ran = shard->loop().run_ready() || ran;
    return ran;
}

}  // namespace poolhall::server
