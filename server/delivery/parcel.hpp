#pragma once

#include "protocol/messages.hpp"

#include <memory>
#include <string>

namespace poolhall::server {

/// A message on its way to a session. Both parts are immutable and shared by all who get it.
struct Parcel {
    std::shared_ptr<const protocol::ServerMessage> message;
    std::shared_ptr<const std::string>
        bytes;  ///< encoded for the session; null: encode when it is sent
};

}  // namespace poolhall::server
