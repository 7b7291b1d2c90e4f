#include "server/room/request.hpp"

#include <cassert>
#include <utility>

namespace poolhall::server {

Request::Request(RequestSpec spec) : spec_(std::move(spec)) {}

Request::Request(Request&& other) noexcept
    : spec_(std::move(other.spec_)), open_(std::exchange(other.open_, false)) {}

Request::~Request() {
    assert(!open_ && "a request was dropped without an answer");
    if (open_)
        std::move(*this).reject(
            {protocol::RejectCode::kStorage, "The server has not carried this out."});
}

void Request::accept(Standing now) && {
    finish(protocol::Accepted{spec_.seq}, std::move(now));
}

void Request::join(protocol::Joined joined, Standing now) && {
    joined.seq = spec_.seq;
    finish(joined, std::move(now));
}

void Request::reject(Refusal refusal) && {
    spec_.counters.rejects.fetch_add(1, std::memory_order_relaxed);
    finish(protocol::Reject{spec_.seq, refusal.code, std::move(refusal.reason)}, spec_.standing);
}

void Request::finish(const protocol::ServerMessage& answer, Standing now) {
    assert(open_);
    open_ = false;
    spec_.shards.send(spec_.member, answer);
    spec_.done(std::move(now));
}

}  // namespace poolhall::server
