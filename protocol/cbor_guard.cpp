#include "protocol/cbor_guard.hpp"

#include "protocol/limits.hpp"

#include <array>
#include <cstdint>

namespace poolhall::protocol {
namespace {

/// The three high bits of an item's first byte.
enum class Major : std::uint8_t {
    kUnsigned,
    kNegative,
    kBytes,
    kText,
    kArray,
    kMap,
    kTag,
    kSimple
};

/// An array or map that is not complete yet.
struct Open {
    std::uint64_t items = 0;  ///< still to come; a map's keys and values count one each
    bool map = false;
};

class Guard {
  public:
    explicit Guard(std::string_view bytes) : bytes_(bytes) {}

    std::optional<std::string> run() {
        do {
            if (const char* fault = item()) return fault + (" at byte " + std::to_string(at_));
            while (depth_ > 0 && open_[depth_ - 1].items == 0)
                --depth_;
        } while (depth_ > 0);
        if (at_ != bytes_.size())
            return "bytes after the end of the message at byte " + std::to_string(at_);
        return std::nullopt;
    }

  private:
    /// Passes over one item's head, and over its text if it is one.
    const char* item() {
        if (at_ == bytes_.size()) return "the CBOR ends too soon";
        const auto first = static_cast<std::uint8_t>(bytes_[at_]);
        const auto major = static_cast<Major>(first >> 5U);
        if (is_key() && major != Major::kText) return "a map key that is not text";
        if (depth_ > 0) --open_[depth_ - 1].items;
        std::uint64_t argument = 0;
        if (const char* fault = head(first & 0x1FU, argument)) return fault;
        switch (major) {
            case Major::kUnsigned:
            case Major::kNegative:
                return nullptr;
            case Major::kText:
                return text(argument);
            case Major::kArray:
                return container(argument, false);
            case Major::kMap:
                return container(argument, true);
            case Major::kSimple:
                return simple(first & 0x1FU);
            case Major::kBytes:
                return "a CBOR byte string";
            case Major::kTag:
                return "a CBOR tag";
        }
        return "not CBOR";
    }

    /// A map has an even number of items to come just before a key.
    [[nodiscard]] bool is_key() const {
        return depth_ > 0 && open_[depth_ - 1].map && open_[depth_ - 1].items % 2 == 0;
    }

    /// The argument that follows the five low bits of an item's first byte.
    const char* head(unsigned info, std::uint64_t& argument) {
        ++at_;
        argument = info;
        if (info < 24) return nullptr;
        if (info == 31) return "a CBOR item of indefinite length";
        if (info > 27) return "a reserved CBOR item";
        const std::size_t count = std::size_t{1} << (info - 24);
        if (bytes_.size() - at_ < count) return "the CBOR ends too soon";
        argument = 0;
        for (std::size_t i = 0; i < count; ++i)
            argument = argument << 8U | static_cast<std::uint8_t>(bytes_[at_++]);
        return nullptr;
    }

    const char* text(std::uint64_t length) {
        if (length > bytes_.size() - at_) return "CBOR text longer than the message";
        at_ += length;
        return nullptr;
    }

    const char* container(std::uint64_t count, bool map) {
        // Each item takes a byte at least, so a count beyond the bytes left is a lie; this also
        // keeps 2 * count in range.
        if (count > bytes_.size() - at_) return "a CBOR length beyond the message";
        if (depth_ == kMaxNesting) return "arrays or objects nested too deeply";
        open_[depth_++] = {map ? 2 * count : count, map};
        return nullptr;
    }

    static const char* simple(unsigned info) {
        const bool literal = info >= 20 && info <= 22;  // false, true, null
        const bool number = info >= 25 && info <= 27;   // half, single and double precision
        return literal || number ? nullptr : "a CBOR simple value other than false, true and null";
    }

    std::string_view bytes_;
    std::size_t at_ = 0;
    std::array<Open, kMaxNesting> open_;
    std::size_t depth_ = 0;
};

}  // namespace

std::optional<std::string> find_cbor_fault(std::string_view bytes) {
    return Guard(bytes).run();
}

}  // namespace poolhall::protocol
