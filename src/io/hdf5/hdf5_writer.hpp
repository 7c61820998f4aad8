// SPDX-License-Identifier: GPL-3.0-or-later
// Builds an HDF5 file of what a layout writes.
//
// Dimensions are those of netCDF-4: scales of HDF5, by which other programs know that z is the first index of the
// outline. The bytes depend on nothing but the content (no clock, no object timestamps).
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "hdf5_handle.hpp"
#include "hdf5_sink.hpp"
#include "io/layout/writer.hpp"

namespace hdconj::io::hdf5 {

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

/// A group or the root of a @ref NewFile.
class FileGroup final : public layout::GroupSink
{
  public:
    /// @param place       open file or group
    /// @param tools       both must outlive the object's last call
    /// @param dimensions  of the group, with those that its datasets make; outlives it too
    FileGroup(hid_t place, Tools const& tools, Dimensions& dimensions)
        : place_(place), tools_(&tools), dimensions_(&dimensions)
    {
    }

    void group(std::string const& name, std::function<void(layout::GroupSink&)> const& fill) override;
    void dataset(std::string const& name, layout::Shape const& shape, layout::Values const& values,
                 layout::About const& about) override;
    /// At no cost: a hard link.
    void link(std::string const& name, std::string const& other) override;
    void attribute(std::string const& name, layout::AttributeValue const& value) override;

  private:
    [[nodiscard]] Dataset bare_dataset(std::string const& name, layout::Shape const& shape, hid_t stored) const;
    void attach(hid_t dataset, std::string const& name, layout::Shape const& shape, layout::Dims const& dims) const;
    [[nodiscard]] hobj_ref_t scale_for(char const* dim, hsize_t size) const;
    hobj_ref_t register_scale(hid_t dataset, std::string const& name, hsize_t size) const;

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

    [[nodiscard]] layout::Writer root() { return layout::Writer(root_); }
    /// All bytes are in the sink then, as long as nothing more is written.
    void flush() const;

  private:
    Tools tools_;
    Dimensions dimensions_;
    File file_;
    FileGroup root_;
};

/// Writes a file: @p fill is called with the writer of its root.
/// @throws FileError with the cause; the target is as it was then
void write_file(std::filesystem::path const& file, std::function<void(layout::Writer const&)> const& fill);

}  // namespace hdconj::io::hdf5
