#pragma once

#include "server/http/reply.hpp"
#include "shared/result.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace poolhall::server {

/// What a request is for.
struct RequestTarget {
    std::string path;  ///< with its query: "/api/replays?limit=2"
    std::string host;  ///< HOST[:PORT]; empty where the request names none
};

/// Reads a request line's target and its Host fields as RFC 9112, section 3.2, has it: the target
/// may be a path or a whole URI, whose authority then counts instead of Host; HTTP/1.1 needs one
/// Host, and no version may have two or one that is none. `version` is 10 for HTTP/1.0, 11 for
/// HTTP/1.1.
[[nodiscard]] Result<RequestTarget, HttpReply> read_target(
    unsigned version, std::string_view target, const std::vector<std::string_view>& hosts);

}  // namespace poolhall::server
