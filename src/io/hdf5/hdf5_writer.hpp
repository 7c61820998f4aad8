// SPDX-License-Identifier: GPL-3.0-or-later
// Builds an HDF5 file: groups, datasets with units, attributes. Private to src/io.
//
// The bytes depend on nothing but the content (no clock, no object timestamps).
#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "hdconj/base/vec2.hpp"
#include "hdf5_handle.hpp"
#include "hdf5_sink.hpp"

namespace hdconj::io::hdf5 {

/// Dimensions of a dataset, slowest first.
using Shape = std::vector<hsize_t>;

/// What all datasets and attributes of a file are made with. Made once: that is a third of the time of a small file.
struct Tools
{
    Tools();

    Type text;            ///< variable-length UTF-8
    Space scalar;         ///< one value
    Properties timeless;  ///< creation without timestamps, so that equal content gives equal bytes
    Properties frugal;    ///< transfer with a small conversion buffer
};

/// Writes into one group or the root of a @ref NewFile.
class Writer
{
  public:
    /// @param place  open file, group or dataset
    /// @param tools  both must outlive the writer's last call
    Writer(hid_t place, Tools const& tools) : place_(place), tools_(&tools) {}

    /// Makes the group @p name and fills it: @p fill is called with its writer.
    template <class Fill>
    void group(std::string const& name, Fill fill) const
    {
        Group const made(H5Gcreate2(place_, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), "create group");
        fill(Writer(made, *tools_));
    }
    /// A group for each of @p items, @p name with its number behind it: @p write is called with its writer and the
    /// item.
    template <class Items, class Write>
    void groups(std::string const& name, Items const& items, Write write) const
    {
        for (std::size_t i = 0; i < items.size(); ++i)
            group(fmt::format("{}_{:03}", name, i), [&](Writer const& made) { write(made, items[i]); });
    }

    /// @param units  "mm", "mm^2", "rad", "s", "1", "N", "N mm", "N/mm", "N mm/rad" or "MPa"
    void numbers(std::string const& name, std::vector<double> const& values, char const* units) const;
    void integers(std::string const& name, std::vector<int> const& values, char const* units = "1") const;
    /// Shape (n,2).
    void points(std::string const& name, std::vector<Vec2> const& points, char const* units = "mm") const;
    /// Doubles of any shape, row by row.
    void array(std::string const& name, Shape const& shape, double const* values, char const* units) const;
    /// Integers of any shape, row by row.
    void array(std::string const& name, Shape const& shape, int const* values, char const* units = "1") const;
    /// Variable-length UTF-8 strings.
    void texts(std::string const& name, std::vector<std::string> const& values, char const* units = "1") const;

    /// A second name of the dataset @p name, at no cost: a hard link.
    void link(std::string const& name, std::string const& other) const;

    void attribute(std::string const& name, std::string const& text) const;
    void attribute(std::string const& name, std::vector<std::string> const& texts) const;
    void attribute(std::string const& name, double value) const;
    void attribute(std::string const& name, int value) const;
    /// True and false as 1 and 0 (one byte).
    void flag(std::string const& name, bool value) const;

  private:
    [[nodiscard]] Dataset dataset(std::string const& name, Shape const& shape, hid_t stored, char const* units) const;
    void fill(hid_t dataset, hid_t given, void const* values, hid_t transfer) const;
    void scalar(std::string const& name, hid_t stored, hid_t given, void const* value) const;

    hid_t place_;
    Tools const* tools_;
};

/// An HDF5 file that is being made.
class NewFile
{
  public:
    /// @param sink  takes the bytes; must outlive the file
    explicit NewFile(Sink& sink);

    [[nodiscard]] Writer root() const { return {file_, tools_}; }
    /// All bytes are in the sink then, as long as nothing more is written.
    void flush() const;

  private:
    Tools tools_;
    File file_;
};

/// Writes a file: @p fill is called with the writer of its root.
/// @throws FileError with the cause; the target is as it was then
void write_file(std::filesystem::path const& file, std::function<void(Writer const&)> const& fill);

}  // namespace hdconj::io::hdf5
