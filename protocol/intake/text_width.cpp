#include "protocol/intake/text_width.hpp"

#include <algorithm>
#include <utf8proc.h>

namespace poolhall::protocol {

std::size_t text_width(std::string_view text) {
    std::size_t width = 0;
    while (!text.empty()) {
        utf8proc_int32_t character = 0;
        const utf8proc_ssize_t bytes =
            utf8proc_iterate(reinterpret_cast<const utf8proc_uint8_t*>(text.data()),
                             static_cast<utf8proc_ssize_t>(text.size()), &character);
        width += bytes > 0 ? static_cast<std::size_t>(utf8proc_charwidth(character)) : 1;
        text.remove_prefix(static_cast<std::size_t>(std::max<utf8proc_ssize_t>(bytes, 1)));
    }
    return width;
}

}  // namespace poolhall::protocol
