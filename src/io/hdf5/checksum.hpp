// SPDX-License-Identifier: GPL-3.0-or-later
// A line behind the end of an HDF5 file that says whether its bytes are those that were written. HDF5 passes over it,
// and a program that changes the file cuts it off.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace hdconj::io::hdf5 {

/// CRC-32 of bytes that come one after the other, as in zlib and ISO 3309: it finds every damage of a single byte.
class Checksum
{
  public:
    void add(std::string_view bytes);
    /// "hdconj crc32 cbf43926\n" of what was added.
    [[nodiscard]] std::string line() const;

    static constexpr std::string_view mark = "hdconj crc32 ";
    static constexpr std::size_t line_length = mark.size() + 9;

  private:
    unsigned long state_ = 0;
};

/// Whether @p file ends with a line that does not fit the bytes before it. A file without one is of another program, or
/// of an earlier version: nothing is known of it.
[[nodiscard]] bool is_damaged(std::filesystem::path const& file);

}  // namespace hdconj::io::hdf5
