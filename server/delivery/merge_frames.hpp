#pragma once

#include "protocol/messages.hpp"

namespace poolhall::server {

/// `newer` as a client that missed `older` needs it: balls that moved in either, the events of
/// both. Both belong to one shot, `older` to the earlier tick.
[[nodiscard]] protocol::Frame merge(const protocol::Frame& older, const protocol::Frame& newer);

}  // namespace poolhall::server
