#pragma once

#include <string>
#include <string_view>

// Random names and the tokens that bring players back to their seats.
namespace poolhall::server {

/// SHA-256 of a token, 64 lower-case hex digits. Only this is kept, so that neither memory nor the
/// store gives a seat away.
using TokenHash = std::string;

/// 128 bits of the system's random generator as protocol::kTokenHexDigits lower-case hex digits.
/// This and the other random names throw std::runtime_error if the generator fails.
[[nodiscard]] std::string new_token();
/// A join code: protocol::kCodeLetters letters of protocol::kCodeAlphabet, each as likely.
[[nodiscard]] std::string new_join_code();
/// A match's id, also of its replay: 16 lower-case hex digits.
[[nodiscard]] std::string new_match_id();

[[nodiscard]] TokenHash hash_token(std::string_view token);
/// Compares in a time that does not depend on where the two differ.
[[nodiscard]] bool same_token(const TokenHash& a, const TokenHash& b);

}  // namespace poolhall::server
