#pragma once

#include <string>
#include <utility>
#include <vector>

namespace poolhall::server {

/// An HTTP response, apart from how it is sent.
struct HttpReply {
    int status = 200;
    std::string type = "application/json";
    std::string body;
    std::vector<std::pair<std::string, std::string>> headers;  ///< further ones
};

/// {"error": "..."} with the status.
[[nodiscard]] HttpReply error_reply(int status, const std::string& sentence);

}  // namespace poolhall::server
