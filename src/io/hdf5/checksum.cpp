// SPDX-License-Identifier: GPL-3.0-or-later
#include "checksum.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <fstream>

namespace hdconj::io::hdf5 {

void Checksum::add(std::string_view bytes)
{
    state_ = crc32_z(state_, reinterpret_cast<unsigned char const*>(bytes.data()), bytes.size());
}

std::string Checksum::line() const
{
    return fmt::format("{}{:08x}\n", mark, state_);
}

bool is_damaged(std::filesystem::path const& file)
{
    constexpr std::size_t block = std::size_t{1} << 20;
    std::ifstream stored(file, std::ios::binary | std::ios::ate);
    std::streamoff const size = stored.tellg();
    if (size < static_cast<std::streamoff>(Checksum::line_length))
        return false;
    std::size_t left = static_cast<std::size_t>(size) - Checksum::line_length;
    std::string line(Checksum::line_length, '\0');
    stored.seekg(static_cast<std::streamoff>(left));
    if (!stored.read(line.data(), static_cast<std::streamsize>(line.size())) || !line.starts_with(Checksum::mark))
        return false;
    stored.seekg(0);
    Checksum checksum;
    for (std::string bytes; left > 0; left -= bytes.size()) {
        bytes.resize(std::min(left, block));
        if (!stored.read(bytes.data(), static_cast<std::streamsize>(bytes.size())))
            return true;
        checksum.add(bytes);
    }
    return checksum.line() != line;
}

}  // namespace hdconj::io::hdf5
