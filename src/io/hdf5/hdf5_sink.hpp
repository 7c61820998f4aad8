// SPDX-License-Identifier: GPL-3.0-or-later
// Where the bytes of an HDF5 file go while it is being made.
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <string_view>

#include "hdf5_handle.hpp"

namespace hdconj::io::hdf5 {

/// The bytes of a file that HDF5 writes, at places of its choice and not in their order.
///
/// The beginning, where it goes back most, stays in memory until the end and is one write then: a usual result, of 100
/// to 500 kB, as a whole. What lies behind goes into the file at once, so that a large result is not in memory a second
/// time. Nothing can be written into the midst of a pipe: there everything stays in memory.
///
/// What goes wrong on the disk is kept as the system's error number, and what follows is written nowhere: HDF5 does not
/// fail in the midst of its work, where it leaves identifiers open, and the cause is not one in its words.
class Sink
{
  public:
    /// All in memory.
    Sink() = default;
    /// A file that is still open loses its sink: HDF5 closes what it could not close at the program's end, and that
    /// goes nowhere.
    ~Sink();
    Sink(Sink const&) = delete;
    Sink& operator=(Sink const&) = delete;
    /// @param descriptor  open for writing, empty; not owned
    /// @param goes_back   a plain file, open for reading too: can be written anywhere
    Sink(int descriptor, bool goes_back);

    /// @param at  from the file's beginning [bytes]
    void write(std::size_t at, std::string_view bytes);
    /// What was not written is zero.
    void read(std::size_t at, std::size_t size, char* bytes) const;
    /// The file ends here: cut, or filled with zeros.
    void end_at(std::size_t end) { end_ = end; }
    [[nodiscard]] std::size_t end() const { return end_; }

    /// Writes what was held back and the line of the checksum; the file is whole then. @returns 0, or the system's
    /// error number of the first write that failed
    [[nodiscard]] int finish();
    [[nodiscard]] int error() const { return error_; }
    /// The whole file with that line, for one that is all in memory.
    [[nodiscard]] std::string bytes() const;

    /// The file that writes here, as HDF5's driver knows it; nothing where there is none.
    struct Writing;
    void written_by(Writing* file) { file_ = file; }

  private:
    [[nodiscard]] std::string checksum_line() const;

    static constexpr int none = -1;

    std::size_t most_held_ = std::numeric_limits<std::size_t>::max();
    int descriptor_ = none;
    bool goes_back_ = false;
    int error_ = 0;
    std::size_t end_ = 0;
    std::string held_;
    Writing* file_ = nullptr;
};

/// A new HDF5 file whose bytes go into @p sink, as long as that lives.
/// @throws Failure
[[nodiscard]] File create_in(Sink& sink);

}  // namespace hdconj::io::hdf5
