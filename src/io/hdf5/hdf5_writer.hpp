// SPDX-License-Identifier: GPL-3.0-or-later
// Builds an HDF5 file: groups, datasets with units, meaning and named dimensions, attributes. Private to src/io.
//
// Dimensions are those of netCDF-4: scales of HDF5, by which other programs know that z is the first index of the
// outline. The bytes depend on nothing but the content (no clock, no object timestamps).
#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "hdconj/base/vec2.hpp"
#include "hdf5_handle.hpp"
#include "hdf5_sink.hpp"

namespace hdconj::io::hdf5 {

/// Dimensions of a dataset, slowest first.
using Shape = std::vector<hsize_t>;

/// Names of the dimensions of a dataset, slowest first.
using Dims = std::vector<char const*>;

/// What a reader is told of a dataset beside its numbers.
struct About
{
    char const* units;    ///< "mm", "mm^2", "rad", "s", "1", "N", "N mm", "N/mm", "N mm/rad" or "MPa"
    std::string meaning;  ///< in one line
    Dims dims;
};

/// The dimensions that a group has, and those of the groups around it.
class Dimensions
{
  public:
    explicit Dimensions(Dimensions const* outer = nullptr) : outer_(outer) {}

    void add(std::string const& name, hsize_t size, hobj_ref_t scale) { own_.push_back({name, size, scale}); }
    /// The scale of a dimension; none where no dataset had it yet. @throws std::logic_error where its size is not @p
    /// size
    [[nodiscard]] std::optional<hobj_ref_t> scale_of(std::string const& name, hsize_t size) const;

  private:
    struct Dimension
    {
        std::string name;
        hsize_t size;
        hobj_ref_t scale;
    };
    std::vector<Dimension> own_;
    Dimensions const* outer_;
};

/// What all datasets and attributes of a file are made with. Made once: that is a third of the time of a small file.
struct Tools
{
    Tools();

    Type text;            ///< variable-length UTF-8
    Type scale_class;     ///< text of the length that the library's dimension scales have
    Type scale_name;      ///< the same for the name of a dimension without numbers
    Type scales;          ///< one list of scales for each dimension
    Space scalar;         ///< one value
    Properties timeless;  ///< datasets without timestamps, so that equal content gives equal bytes
    Properties frugal;    ///< transfer with a small conversion buffer
};

/// Writes into one group or the root of a @ref NewFile.
class Writer
{
  public:
    /// @param place       open file, group or dataset
    /// @param tools       both must outlive the writer's last call
    /// @param dimensions  of the group, with those that its datasets make; outlives it too
    Writer(hid_t place, Tools const& tools, Dimensions& dimensions)
        : place_(place), tools_(&tools), dimensions_(&dimensions)
    {
    }

    /// Makes the group @p name and fills it: @p fill is called with its writer.
    template <class Fill>
    void group(std::string const& name, Fill fill) const
    {
        Group const made(H5Gcreate2(place_, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), "create group");
        Dimensions inner(dimensions_);
        fill(Writer(made, *tools_, inner));
    }
    /// A group for each of @p items, @p name with its number behind it: @p write is called with its writer and the
    /// item.
    template <class Items, class Write>
    void groups(std::string const& name, Items const& items, Write write) const
    {
        for (std::size_t i = 0; i < items.size(); ++i)
            group(fmt::format("{}_{:03}", name, i), [&](Writer const& made) { write(made, items[i]); });
    }

    /// A dataset of one dimension that has the dimension's name holds its coordinates, and is written before all others
    /// that have this dimension.
    void numbers(std::string const& name, std::vector<double> const& values, About const& about) const;
    void integers(std::string const& name, std::vector<int> const& values, About const& about) const;
    /// Shape (n,2), n by @p dim.
    void points(std::string const& name, std::vector<Vec2> const& points, char const* meaning, char const* dim) const;
    /// Doubles of any shape, row by row.
    void array(std::string const& name, Shape const& shape, double const* values, About const& about) const;
    /// Integers of any shape, row by row.
    void array(std::string const& name, Shape const& shape, int const* values, About const& about) const;
    /// Variable-length UTF-8 strings.
    void texts(std::string const& name, std::vector<std::string> const& values, char const* meaning,
               char const* dim) const;

    /// A second name of the dataset @p name, at no cost: a hard link.
    void link(std::string const& name, std::string const& other) const;

    void attribute(std::string const& name, std::string const& text) const;
    void attribute(std::string const& name, std::vector<std::string> const& texts) const;
    void attribute(std::string const& name, double value) const;
    void attribute(std::string const& name, int value) const;
    /// True and false as 1 and 0 (one byte).
    void flag(std::string const& name, bool value) const;

  private:
    /// Types of the numbers in the file and in memory, and properties of the transfer.
    struct Transfer
    {
        hid_t stored, given, properties;
    };
    void dataset(std::string const& name, Shape const& shape, Transfer const& transfer, void const* values,
                 About const& about) const;
    [[nodiscard]] Dataset bare_dataset(std::string const& name, Shape const& shape, hid_t stored) const;
    void attach(hid_t dataset, std::string const& name, Shape const& shape, Dims const& dims) const;
    [[nodiscard]] hobj_ref_t scale_for(char const* dim, hsize_t size) const;
    hobj_ref_t register_scale(hid_t dataset, std::string const& name, hsize_t size) const;
    void scalar(std::string const& name, hid_t stored, hid_t given, void const* value) const;

    hid_t place_;
    Tools const* tools_;
    Dimensions* dimensions_;
};

/// An HDF5 file that is being made.
class NewFile
{
  public:
    /// @param sink  takes the bytes; must outlive the file
    explicit NewFile(Sink& sink);

    [[nodiscard]] Writer root() { return {file_, tools_, dimensions_}; }
    /// All bytes are in the sink then, as long as nothing more is written.
    void flush() const;

  private:
    Tools tools_;
    Dimensions dimensions_;
    File file_;
};

/// Writes a file: @p fill is called with the writer of its root.
/// @throws FileError with the cause; the target is as it was then
void write_file(std::filesystem::path const& file, std::function<void(Writer const&)> const& fill);

}  // namespace hdconj::io::hdf5
