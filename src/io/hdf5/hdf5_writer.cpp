// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdf5_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <type_traits>
#include <variant>

#include "file/atomic_file_posix.hpp"
#include "hdconj/error.hpp"
#include "hdconj/file/atomic_file.hpp"

namespace hdconj::io::hdf5 {
namespace {

/// For texts, which HDF5 converts one by one. Its own choice of 1 MB costs a millisecond to clear for every dataset.
constexpr std::size_t conversion_buffer = std::size_t{1} << 12;

Space simple(layout::Shape const& shape)
{
    std::vector<hsize_t> const sizes(shape.begin(), shape.end());
    return {H5Screate_simple(static_cast<int>(sizes.size()), sizes.data(), nullptr), "create dataspace"};
}

std::vector<char const*> pointers(std::string const* texts, std::size_t count)
{
    std::vector<char const*> result(count);
    std::transform(texts, texts + count, result.begin(), [](std::string const& text) { return text.c_str(); });
    return result;
}

/// What marks a dataset as the scale of a dimension, and the length of the name of one without numbers: as the library
/// and netCDF-4 write them.
constexpr char dimension_scale[] = "DIMENSION_SCALE";
constexpr std::size_t scale_name_length = sizeof "This is a netCDF dimension but not a netCDF variable.0123456789";

Type text_of_length(std::size_t length)
{
    Type type(H5Tcopy(H5T_C_S1), "copy string type");
    checked(H5Tset_size(type, length), "set string length");
    return type;
}

/// One value: its types in the file and in memory, and where it is.
struct Scalar
{
    hid_t stored, given;
    void const* value;
};

void write_scalar(hid_t place, hid_t space, std::string const& name, Scalar const& scalar)
{
    Attribute const made(H5Acreate2(place, name.c_str(), scalar.stored, space, H5P_DEFAULT, H5P_DEFAULT),
                         "create attribute");
    checked(H5Awrite(made, scalar.given, scalar.value), "write attribute");
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
      scale_class(text_of_length(sizeof dimension_scale)),
      scale_name(text_of_length(scale_name_length)),
      scales(H5Tvlen_create(H5T_STD_REF_OBJ), "create type"),
      scalar(H5Screate(H5S_SCALAR), "create dataspace"),
      timeless(H5Pcreate(H5P_DATASET_CREATE), "create properties"),
      frugal(H5Pcreate(H5P_DATASET_XFER), "create properties")
{
    checked(H5Pset_obj_track_times(timeless, false), "switch timestamps off");
    checked(H5Pset_buffer(frugal, conversion_buffer, nullptr, nullptr), "set conversion buffer");
}

std::optional<hobj_ref_t> Dimensions::scale_of(std::string const& name, hsize_t size) const
{
    for (auto const& each : own_) {
        if (each.name != name)
            continue;
        if (each.size != size)
            throw std::logic_error("datasets of one group differ in their dimension " + name);
        return each.scale;
    }
    return outer_ != nullptr ? outer_->scale_of(name, size) : std::nullopt;
}

void FileGroup::group(std::string const& name, std::function<void(layout::GroupSink&)> const& fill)
{
    Group const made(H5Gcreate2(place_, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), "create group");
    Dimensions inner(dimensions_);
    FileGroup place(made, *tools_, inner);
    fill(place);
}

void FileGroup::dataset(std::string const& name, layout::Shape const& shape, layout::Values const& values,
                        layout::About const& about)
{
    struct Transfer
    {
        hid_t stored, given, properties;
        void const* values;
    };
    std::vector<char const*> texts;
    auto const transfer = std::visit(
        [&](auto const* first) -> Transfer {
            using Value = std::remove_const_t<std::remove_pointer_t<decltype(first)>>;
            if constexpr (std::is_same_v<Value, double>)
                return {H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, H5P_DEFAULT, first};
            if constexpr (std::is_same_v<Value, int>)
                return {H5T_STD_I32LE, H5T_NATIVE_INT, H5P_DEFAULT, first};
            if constexpr (std::is_same_v<Value, std::string>) {
                texts = pointers(first, shape.front());
                return {tools_->text, tools_->text, tools_->frugal, texts.data()};
            }
        },
        values);
    Dataset const made = bare_dataset(name, shape, transfer.stored);
    FileGroup of_dataset(made, *tools_, *dimensions_);
    of_dataset.attribute("units", std::string(about.units));
    of_dataset.attribute("long_name", about.meaning);
    attach(made, name, shape, about.dims);
    if (std::find(shape.begin(), shape.end(), std::size_t{0}) == shape.end())
        checked(H5Dwrite(made, transfer.given, H5S_ALL, H5S_ALL, transfer.properties, transfer.values),
                "write dataset");
}

Dataset FileGroup::bare_dataset(std::string const& name, layout::Shape const& shape, hid_t stored) const
{
    return {H5Dcreate2(place_, name.c_str(), stored, simple(shape), H5P_DEFAULT, tools_->timeless, H5P_DEFAULT),
            "create dataset"};
}

/// Names the dimensions of a dataset as the library's H5DSattach_scale() does, but for the list at the scale of all
/// that refer to it: a list that grows with each, and that no reader needs.
void FileGroup::attach(hid_t dataset, std::string const& name, layout::Shape const& shape,
                       layout::Dims const& dims) const
{
    if (dims.size() != shape.size())
        throw std::logic_error("dataset " + name + " has not one name for each dimension");
    if (dims.size() == 1 && name == dims.front()) {
        register_scale(dataset, name, shape.front());
        return;
    }
    std::vector<hobj_ref_t> scales(dims.size());
    std::vector<hvl_t> lists(dims.size());
    for (std::size_t i = 0; i < dims.size(); ++i) {
        scales[i] = scale_for(dims[i], shape[i]);
        lists[i] = {1, &scales[i]};
    }
    Space const space = simple({dims.size()});
    Attribute const made(H5Acreate2(dataset, "DIMENSION_LIST", tools_->scales, space, H5P_DEFAULT, H5P_DEFAULT),
                         "create attribute");
    checked(H5Awrite(made, tools_->scales, lists.data()), "write attribute");
}

/// The scale of a dimension; where it has none yet, one without numbers in this group, as netCDF-4 makes it.
hobj_ref_t FileGroup::scale_for(char const* dim, hsize_t size) const
{
    if (auto const known = dimensions_->scale_of(dim, size))
        return *known;
    Dataset const made = bare_dataset(dim, {size}, H5T_STD_I32LE);
    std::string const text = fmt::format("This is a netCDF dimension but not a netCDF variable.{:10}", size);
    write_scalar(made, tools_->scalar, "NAME", {tools_->scale_name, tools_->scale_name, text.c_str()});
    return register_scale(made, dim, size);
}

hobj_ref_t FileGroup::register_scale(hid_t dataset, std::string const& name, hsize_t size) const
{
    write_scalar(dataset, tools_->scalar, "CLASS", {tools_->scale_class, tools_->scale_class, dimension_scale});
    hobj_ref_t scale = 0;
    checked(H5Rcreate(&scale, dataset, ".", H5R_OBJECT, H5I_INVALID_HID), "refer to a dataset");
    dimensions_->add(name, size, scale);
    return scale;
}

void FileGroup::link(std::string const& name, std::string const& other)
{
    checked(H5Lcreate_hard(place_, name.c_str(), place_, other.c_str(), H5P_DEFAULT, H5P_DEFAULT), "link a dataset");
}

void FileGroup::attribute(std::string const& name, layout::AttributeValue const& value)
{
    auto const scalar = [&](hid_t stored, hid_t given, void const* from) {
        write_scalar(place_, tools_->scalar, name, {stored, given, from});
    };
    std::visit(
        [&](auto const& given) {
            using Value = std::decay_t<decltype(given)>;
            if constexpr (std::is_same_v<Value, double>) {
                scalar(H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, &given);
            } else if constexpr (std::is_same_v<Value, int>) {
                scalar(H5T_STD_I32LE, H5T_NATIVE_INT, &given);
            } else if constexpr (std::is_same_v<Value, bool>) {
                unsigned char const byte = given ? 1 : 0;
                scalar(H5T_STD_U8LE, H5T_NATIVE_UCHAR, &byte);
            } else if constexpr (std::is_same_v<Value, std::string>) {
                char const* const pointer = given.c_str();
                scalar(tools_->text, tools_->text, &pointer);
            } else {
                Space const space = simple({given.size()});
                Attribute const made(H5Acreate2(place_, name.c_str(), tools_->text, space, H5P_DEFAULT, H5P_DEFAULT),
                                     "create attribute");
                if (!given.empty())
                    checked(H5Awrite(made, tools_->text, pointers(given.data(), given.size()).data()),
                            "write attribute");
            }
        },
        value);
}

NewFile::NewFile(Sink& sink) : file_(create_in(sink)), root_(file_, tools_, dimensions_) {}

void NewFile::flush() const
{
    checked(H5Fflush(file_, H5F_SCOPE_GLOBAL), "flush");
}

void write_file(std::filesystem::path const& file, std::function<void(layout::Writer const&)> const& fill)
{
    file::write_atomically(file, [&](std::filesystem::path const& place) {
        bool const goes_back = !file::posix::status_of(place).is_device();
        file::posix::Descriptor out(place, goes_back ? O_RDWR : O_WRONLY);
        if (!out.is_open())
            throw FileError(file, file::posix::cannot_write(errno));
        Sink sink(out.number(), goes_back);
        try {
            Silence const silence;
            NewFile made(sink);
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
