#pragma once

#include "protocol/intake/decode_client.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>

namespace poolhall::protocol::testing {

/// Expects a refusal for a reason, in JSON and, where JSON can be put into CBOR, there too.
inline void expect_refused(const std::string& json, RejectCode code, const std::string& in_reason) {
    const auto result = decode_client(json, Encoding::kJson);
    ASSERT_FALSE(result.ok()) << json;
    EXPECT_EQ(name(result.error().code), name(code)) << json << "\n" << result.error().reason;
    EXPECT_NE(result.error().reason.find(in_reason), std::string::npos) << result.error().reason;

    const auto tree = nlohmann::json::parse(json, nullptr, false);
    if (tree.is_discarded() || code == RejectCode::kMalformed) return;
    std::string cbor;
    nlohmann::json::to_cbor(tree, cbor);
    const auto binary = decode_client(cbor, Encoding::kCbor);
    ASSERT_FALSE(binary.ok()) << json;
    EXPECT_EQ(binary.error().code, code) << json;
}

}  // namespace poolhall::protocol::testing
