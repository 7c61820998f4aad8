// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Builds an HDF5 file in memory: groups, datasets with units, attributes. Private to src/io.
///
/// The file never touches a disk before it is whole: what goes wrong on the disk goes wrong in one plain write, with
/// the system's own reason, and the bytes depend on nothing but the content (no clock, no object timestamps).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "hdconj/geometry/vec2.hpp"
#include "hdf5_handle.hpp"

namespace hdconj::hdf5 {

/// Dimensions of a dataset, slowest first.
using Shape = std::vector<hsize_t>;

/// Writes into one group or the root of a @ref MemoryFile.
class Writer
{
  public:
    /// @param place  open file or group; must outlive the writer's last call
    explicit Writer(hid_t place) : place_(place) {}

    [[nodiscard]] Group group(std::string const& name) const;

    /// @param units  "mm", "rad", "s" or "1"
    void numbers(std::string const& name, std::vector<double> const& values, char const* units) const;
    void integers(std::string const& name, std::vector<int> const& values, char const* units = "1") const;
    /// Shape (n,2).
    void points(std::string const& name, std::vector<Vec2> const& points, char const* units = "mm") const;
    /// Doubles of any shape, row by row.
    void array(std::string const& name, Shape const& shape, double const* values, char const* units) const;
    /// Variable-length UTF-8 strings.
    void texts(std::string const& name, std::vector<std::string> const& values, char const* units = "1") const;

    void attribute(std::string const& name, std::string const& text) const;
    void attribute(std::string const& name, std::vector<std::string> const& texts) const;
    void attribute(std::string const& name, double value) const;
    void attribute(std::string const& name, int value) const;
    /// True and false as 1 and 0 (one byte).
    void flag(std::string const& name, bool value) const;

  private:
    void dataset(std::string const& name, Shape const& shape, hid_t stored, hid_t given, void const* values,
                 char const* units) const;
    void scalar(std::string const& name, hid_t stored, hid_t given, void const* value) const;

    hid_t place_;
};

/// An HDF5 file that exists in memory only.
class MemoryFile
{
  public:
    MemoryFile();

    [[nodiscard]] Writer root() const { return Writer(file_); }
    /// The bytes of the file as they belong on the disk.
    [[nodiscard]] std::string bytes() const;

  private:
    File file_;
};

}  // namespace hdconj::hdf5
