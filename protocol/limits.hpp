#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace poolhall::protocol {

inline constexpr int kVersion = 1;
inline constexpr std::string_view kPath = "/ws";
inline constexpr std::string_view kSubprotocolJson = "poolhall.v1.json";
inline constexpr std::string_view kSubprotocolCbor = "poolhall.v1.cbor";

/// A longer message from a client closes its session with 1009.
inline constexpr std::size_t kMaxClientMessageBytes = 4096;
/// Bound of what a client need accept from a server.
inline constexpr std::size_t kMaxServerMessageBytes = 1U << 20U;
/// Arrays and objects within one another in a message or a scene; deeper ones are refused before a
/// tree is built.
inline constexpr std::size_t kMaxNesting = 8;
inline constexpr std::size_t kMaxNameBytes = 32;  ///< UTF-8, no control characters
/// Join codes are spoken: consonants and digits that cannot be taken for one another, in two
/// groups.
inline constexpr std::size_t kCodeLetters = 6;
inline constexpr std::string_view kCodeAlphabet = "BCDFGHJKLMNPQRSTVWXZ";
inline constexpr std::size_t kMaxGameBytes = 32;      ///< of a ruleset's name
inline constexpr std::size_t kMaxReasonBytes = 1024;  ///< of a sentence meant for people
inline constexpr std::size_t kTokenHexDigits = 32;    ///< 128 random bits
/// Components of a direction: finite, at most this, and not both zero.
inline constexpr double kMaxDirectionComponent = 1e6;
inline constexpr double kMaxPositionComponent = 1e3;  ///< m

}  // namespace poolhall::protocol
