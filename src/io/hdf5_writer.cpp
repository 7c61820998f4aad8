// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdf5_writer.hpp"

#include <type_traits>

namespace hdconj::hdf5 {

namespace {

/// Growth step of the file in memory [bytes]: a usual result is 100 to 500 kB.
constexpr std::size_t memory_step = std::size_t{1} << 18;
/// For texts, which HDF5 converts one by one. Its own choice of 1 MB costs a millisecond to clear for every dataset.
constexpr std::size_t conversion_buffer = std::size_t{1} << 12;
constexpr hbool_t not_backed_by_a_file = 0;

static_assert(sizeof(Vec2) == 2 * sizeof(double) && std::is_standard_layout_v<Vec2>,
              "points are written as they lie in memory");

Type variable_text()
{
    Type type(H5Tcopy(H5T_C_S1), "copy string type");
    checked(H5Tset_size(type, H5T_VARIABLE), "set string length");
    checked(H5Tset_cset(type, H5T_CSET_UTF8), "set character set");
    return type;
}

Space simple(Shape const& shape)
{
    return {H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), "create dataspace"};
}

std::vector<char const*> pointers(std::vector<std::string> const& texts)
{
    std::vector<char const*> result;
    for (auto const& text : texts) {
        result.push_back(text.c_str());
    }
    return result;
}

/// Creation properties without timestamps, so that equal content gives equal bytes.
Properties timeless(hid_t kind)
{
    Properties properties(H5Pcreate(kind), "create properties");
    checked(H5Pset_obj_track_times(properties, false), "switch timestamps off");
    return properties;
}

File create_in_memory()
{
    Properties const access(H5Pcreate(H5P_FILE_ACCESS), "create properties");
    checked(H5Pset_fapl_core(access, memory_step, not_backed_by_a_file), "choose memory");
    return {H5Fcreate("hdconj in memory", H5F_ACC_TRUNC, H5P_DEFAULT, access), "create file"};
}

/// Keeps the innermost description: H5Ewalk goes from the outermost call inwards.
herr_t keep_last(unsigned, H5E_error2_t const* entry, void* text)
{
    if (entry->desc != nullptr) {
        *static_cast<std::string*>(text) = entry->desc;
    }
    return 0;
}

}  // namespace

void fail(char const* doing)
{
    std::string cause;
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_DOWNWARD, keep_last, &cause);
    throw Failure(std::string("HDF5 cannot ") + doing + (cause.empty() ? "" : ": " + cause));
}

Group Writer::group(std::string const& name) const
{
    return {H5Gcreate2(place_, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), "create group"};
}

void Writer::numbers(std::string const& name, std::vector<double> const& values, char const* units) const
{
    array(name, {values.size()}, values.data(), units);
}

void Writer::integers(std::string const& name, std::vector<int> const& values, char const* units) const
{
    dataset(name, {values.size()}, H5T_STD_I32LE, H5T_NATIVE_INT, values.data(), units);
}

void Writer::points(std::string const& name, std::vector<Vec2> const& points, char const* units) const
{
    array(name, {points.size(), 2}, points.empty() ? nullptr : points.front().data(), units);
}

void Writer::array(std::string const& name, Shape const& shape, double const* values, char const* units) const
{
    dataset(name, shape, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, values, units);
}

void Writer::texts(std::string const& name, std::vector<std::string> const& values, char const* units) const
{
    Type const type = variable_text();
    dataset(name, {values.size()}, type, type, pointers(values).data(), units);
}

void Writer::dataset(std::string const& name, Shape const& shape, hid_t stored, hid_t given, void const* values,
                     char const* units) const
{
    Space const space = simple(shape);
    Dataset const made(
        H5Dcreate2(place_, name.c_str(), stored, space, H5P_DEFAULT, timeless(H5P_DATASET_CREATE), H5P_DEFAULT),
        "create dataset");
    Writer(made).attribute("units", std::string(units));
    if (H5Sget_simple_extent_npoints(space) > 0) {
        Properties const transfer(H5Pcreate(H5P_DATASET_XFER), "create properties");
        checked(H5Pset_buffer(transfer, conversion_buffer, nullptr, nullptr), "set conversion buffer");
        checked(H5Dwrite(made, given, H5S_ALL, H5S_ALL, transfer, values), "write dataset");
    }
}

void Writer::attribute(std::string const& name, std::string const& text) const
{
    Type const type = variable_text();
    char const* const pointer = text.c_str();
    scalar(name, type, type, &pointer);
}

void Writer::attribute(std::string const& name, std::vector<std::string> const& texts) const
{
    Type const type = variable_text();
    Space const space = simple({texts.size()});
    Attribute const made(H5Acreate2(place_, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), "create attribute");
    if (!texts.empty()) {
        checked(H5Awrite(made, type, pointers(texts).data()), "write attribute");
    }
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
    Space const space(H5Screate(H5S_SCALAR), "create dataspace");
    Attribute const made(H5Acreate2(place_, name.c_str(), stored, space, H5P_DEFAULT, H5P_DEFAULT), "create attribute");
    checked(H5Awrite(made, given, value), "write attribute");
}

MemoryFile::MemoryFile() : file_(create_in_memory()) {}

std::string MemoryFile::bytes() const
{
    checked(H5Fflush(file_, H5F_SCOPE_GLOBAL), "flush");
    ssize_t const size = checked(H5Fget_file_image(file_, nullptr, 0), "measure the file");
    std::string image(static_cast<std::size_t>(size), '\0');
    checked(H5Fget_file_image(file_, image.data(), image.size()), "take the file");
    return image;
}

}  // namespace hdconj::hdf5
