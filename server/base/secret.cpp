#include "server/base/secret.hpp"

#include "protocol/limits.hpp"

#include <array>
#include <cstddef>
#include <openssl/crypto.h>
#include <openssl/rand.h>
#include <openssl/sha.h>
#include <span>
#include <stdexcept>

namespace poolhall::server {
namespace {

void fill_random(std::span<unsigned char> bytes) {
    if (RAND_bytes(bytes.data(), static_cast<int>(bytes.size())) != 1)
        throw std::runtime_error("the system's random generator failed");
}

std::string to_hex(std::span<const unsigned char> bytes) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string text;
    text.reserve(2 * bytes.size());
    for (const unsigned char byte : bytes) {
        text += kDigits[byte >> 4U];
        text += kDigits[byte & 15U];
    }
    return text;
}

template <std::size_t kByteCount>
std::string random_hex() {
    std::array<unsigned char, kByteCount> bytes{};
    fill_random(bytes);
    return to_hex(bytes);
}

/// A letter of the alphabet without bias: bytes past its last whole multiple are thrown away.
char random_letter() {
    constexpr std::string_view kLetters = protocol::kCodeAlphabet;
    constexpr std::size_t kFair = 256 - 256 % kLetters.size();
    for (;;) {
        std::array<unsigned char, 1> byte{};
        fill_random(byte);
        if (byte[0] < kFair) return kLetters[byte[0] % kLetters.size()];
    }
}

}  // namespace

std::string new_token() {
    return random_hex<protocol::kTokenHexDigits / 2>();
}

std::string new_match_id() {
    return random_hex<8>();
}

std::string new_join_code() {
    std::string code;
    while (code.size() < protocol::kCodeLetters)
        code += random_letter();
    return code;
}

TokenHash hash_token(std::string_view token) {
    std::array<unsigned char, SHA256_DIGEST_LENGTH> hash{};
    // The C interface of OpenSSL takes bytes as unsigned char.
    SHA256(reinterpret_cast<const unsigned char*>(token.data()), token.size(), hash.data());
    return to_hex(hash);
}

bool same_token(const TokenHash& a, const TokenHash& b) {
    return a.size() == b.size() && CRYPTO_memcmp(a.data(), b.data(), a.size()) == 0;
}

}  // namespace poolhall::server
