// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers as bytes of a file.
#pragma once

#include <array>
#include <bit>
#include <string>

namespace hdconj::io {

static_assert(std::endian::native == std::endian::little, "numbers are written as they lie in memory");

template <class Number>
void append_little_endian(std::string& bytes, Number number)
{
    auto const raw = std::bit_cast<std::array<char, sizeof(Number)>>(number);
    bytes.append(raw.data(), raw.size());
}

template <class Number>
void append_big_endian(std::string& bytes, Number number)
{
    auto const raw = std::bit_cast<std::array<char, sizeof(Number)>>(number);
    bytes.append(raw.rbegin(), raw.rend());
}

}  // namespace hdconj::io
