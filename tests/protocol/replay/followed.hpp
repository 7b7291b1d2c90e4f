#pragma once

#include "protocol/replay/log_follower.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

// What following logs has found, for tests.
namespace poolhall::test {

inline std::vector<protocol::Followed> follow(const std::vector<protocol::ReplayRecord>& records,
                                              std::uint32_t edition = kPhysicsEdition) {
    protocol::LogFollower follower(edition);
    std::vector<protocol::Followed> all;
    for (const auto& record : records)
        all.push_back(follower.follow(record));
    return all;
}

/// Those that tell of a shot that could be simulated.
inline std::vector<protocol::Followed> shots_of(std::vector<protocol::Followed> all) {
    std::erase_if(all, [](const protocol::Followed& one) { return !one.shot; });
    return all;
}

/// "SUBJECT: DEVIATION", each.
inline std::vector<std::string> deviations_of(const std::vector<protocol::Followed>& all) {
    std::vector<std::string> found;
    for (const auto& one : all)
        for (const std::string& deviation : one.found.deviations)
            found.push_back(one.subject + ": " + deviation);
    return found;
}

/// The same of remarks.
inline std::vector<std::string> remarks_of(const std::vector<protocol::Followed>& all) {
    std::vector<std::string> found;
    for (const auto& one : all)
        for (const std::string& remark : one.found.remarks)
            found.push_back(one.subject + ": " + remark);
    return found;
}

inline std::string first(const std::vector<std::string>& found) {
    return found.empty() ? "nothing" : found.front();
}

inline bool has(const std::vector<std::string>& found, std::string_view part) {
    return std::any_of(found.begin(), found.end(), [part](const std::string& one) {
        return one.find(part) != std::string::npos;
    });
}

}  // namespace poolhall::test
