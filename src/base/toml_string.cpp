// SPDX-License-Identifier: GPL-3.0-or-later
#include "toml_string.hpp"

#include <fmt/format.h>

namespace hdconj {

std::string toml_string(std::string_view text)
{
    std::string written = "\"";
    for (char const c : text) {
        auto const byte = static_cast<unsigned char>(c);
        if (byte < 0x20 || byte == 0x7f)
            written += fmt::format("\\u{:04x}", byte);
        else
            written += c == '"' || c == '\\' ? std::string{'\\', c} : std::string(1, c);
    }
    return written + '"';
}

}  // namespace hdconj
