#pragma once

#include <string_view>

// What the fuzzers feed with bytes: one function for each decoder, and shot(), for which they
// choose a scene that must keep the laws of physics. Each decoder aborts, with a line on standard
// error, when something that was read does not come back the same after it was written again.
namespace poolhall::fuzz {

void client_json(std::string_view bytes);
void client_cbor(std::string_view bytes);
void server_json(std::string_view bytes);
void server_cbor(std::string_view bytes);
void scene(std::string_view bytes);
void replay(std::string_view bytes);
void shot(std::string_view input);

/// Where `what` is wrong because this does not hold, says so on standard error and aborts.
void require(bool holds, const char* what);

}  // namespace poolhall::fuzz
