// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdf5_writer.hpp"

#include <type_traits>

#include "file/atomic_file_posix.hpp"
#include "hdconj/error.hpp"
#include "hdconj/file/atomic_file.hpp"

namespace hdconj::io::hdf5 {
namespace {

/// For texts, which HDF5 converts one by one. Its own choice of 1 MB costs a millisecond to clear for every dataset.
constexpr std::size_t conversion_buffer = std::size_t{1} << 12;

static_assert(sizeof(Vec2) == 2 * sizeof(double) && std::is_standard_layout_v<Vec2>,
              "points are written as they lie in memory");

Space simple(Shape const& shape)
{
    return {H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), "create dataspace"};
}

std::vector<char const*> pointers(std::vector<std::string> const& texts)
{
    std::vector<char const*> result;
    for (auto const& text : texts)
        result.push_back(text.c_str());
    return result;
}

/// Keeps the innermost description: H5Ewalk goes from the outermost call inwards.
herr_t keep_last(unsigned, H5E_error2_t const* entry, void* text)
{
    if (entry->desc != nullptr)
        *static_cast<std::string*>(text) = entry->desc;
    return 0;
}

}  // namespace

void fail(char const* doing)
{
    std::string cause;
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_DOWNWARD, keep_last, &cause);
    throw Failure(std::string("HDF5 cannot ") + doing + (cause.empty() ? "" : ": " + cause));
}

Tools::Tools()
    : text(text_type()),
      scalar(H5Screate(H5S_SCALAR), "create dataspace"),
      timeless(H5Pcreate(H5P_DATASET_CREATE), "create properties"),
      frugal(H5Pcreate(H5P_DATASET_XFER), "create properties")
{
    checked(H5Pset_obj_track_times(timeless, false), "switch timestamps off");
    checked(H5Pset_buffer(frugal, conversion_buffer, nullptr, nullptr), "set conversion buffer");
}

void Writer::numbers(std::string const& name, std::vector<double> const& values, char const* units) const
{
    array(name, {values.size()}, values.data(), units);
}

void Writer::integers(std::string const& name, std::vector<int> const& values, char const* units) const
{
    array(name, {values.size()}, values.data(), units);
}

void Writer::points(std::string const& name, std::vector<Vec2> const& points, char const* units) const
{
    array(name, {points.size(), 2}, points.empty() ? nullptr : points.front().data(), units);
}

void Writer::array(std::string const& name, Shape const& shape, double const* values, char const* units) const
{
    fill(dataset(name, shape, H5T_IEEE_F64LE, units), H5T_NATIVE_DOUBLE, values, H5P_DEFAULT);
}

void Writer::array(std::string const& name, Shape const& shape, int const* values, char const* units) const
{
    fill(dataset(name, shape, H5T_STD_I32LE, units), H5T_NATIVE_INT, values, H5P_DEFAULT);
}

void Writer::texts(std::string const& name, std::vector<std::string> const& values, char const* units) const
{
    fill(dataset(name, {values.size()}, tools_->text, units), tools_->text, pointers(values).data(), tools_->frugal);
}

Dataset Writer::dataset(std::string const& name, Shape const& shape, hid_t stored, char const* units) const
{
    Space const space = simple(shape);
    Dataset made(H5Dcreate2(place_, name.c_str(), stored, space, H5P_DEFAULT, tools_->timeless, H5P_DEFAULT),
                 "create dataset");
    Writer(made, *tools_).attribute("units", std::string(units));
    return made;
}

void Writer::fill(hid_t dataset, hid_t given, void const* values, hid_t transfer) const
{
    Space const space(H5Dget_space(dataset), "get dataspace");
    if (H5Sget_simple_extent_npoints(space) > 0)
        checked(H5Dwrite(dataset, given, H5S_ALL, H5S_ALL, transfer, values), "write dataset");
}

void Writer::link(std::string const& name, std::string const& other) const
{
    checked(H5Lcreate_hard(place_, name.c_str(), place_, other.c_str(), H5P_DEFAULT, H5P_DEFAULT), "link a dataset");
}

void Writer::attribute(std::string const& name, std::string const& text) const
{
    char const* const pointer = text.c_str();
    scalar(name, tools_->text, tools_->text, &pointer);
}

void Writer::attribute(std::string const& name, std::vector<std::string> const& texts) const
{
    Space const space = simple({texts.size()});
    Attribute const made(H5Acreate2(place_, name.c_str(), tools_->text, space, H5P_DEFAULT, H5P_DEFAULT),
                         "create attribute");
    if (!texts.empty())
        checked(H5Awrite(made, tools_->text, pointers(texts).data()), "write attribute");
}

void Writer::attribute(std::string const& name, double value) const
{
    scalar(name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, &value);
}

void Writer::attribute(std::string const& name, int value) const
{
    scalar(name, H5T_STD_I32LE, H5T_NATIVE_INT, &value);
}

void Writer::flag(std::string const& name, bool value) const
{
    unsigned char const byte = value ? 1 : 0;
    scalar(name, H5T_STD_U8LE, H5T_NATIVE_UCHAR, &byte);
}

void Writer::scalar(std::string const& name, hid_t stored, hid_t given, void const* value) const
{
    Attribute const made(H5Acreate2(place_, name.c_str(), stored, tools_->scalar, H5P_DEFAULT, H5P_DEFAULT),
                         "create attribute");
    checked(H5Awrite(made, given, value), "write attribute");
}

NewFile::NewFile(Sink& sink) : file_(create_in(sink)) {}

void NewFile::flush() const
{
    checked(H5Fflush(file_, H5F_SCOPE_GLOBAL), "flush");
}

void write_file(std::filesystem::path const& file, std::function<void(Writer const&)> const& fill)
{
    file::write_atomically(file, [&](std::filesystem::path const& place) {
        bool const goes_back = !file::posix::status_of(place).is_device();
        file::posix::Descriptor out(place, goes_back ? O_RDWR : O_WRONLY);
        if (!out.is_open())
            throw FileError(file, file::posix::cannot_write(errno));
        Sink sink(out.number(), goes_back);
        try {
            Silence const silence;
            NewFile const made(sink);
            fill(made.root());
            made.flush();
        } catch (Failure const& failure) {
            throw FileError(file, sink.error() != 0 ? file::posix::cannot_write(sink.error()) : failure.what());
        }
        int const written = sink.finish();
        int const closed = out.close();
        if (int const error = written != 0 ? written : closed; error != 0)
            throw FileError(file, file::posix::cannot_write(error));
    });
}

}  // namespace hdconj::io::hdf5
