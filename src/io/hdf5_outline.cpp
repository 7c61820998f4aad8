// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <memory>

#include "hdconj/io/atomic_file.hpp"
#include "hdconj/io/stored_outline.hpp"
#include "hdf5_handle.hpp"

namespace hdconj {
namespace {

using namespace hdf5;

constexpr int newest_format = 1;

Type text_type()
{
    Type type(H5Tcopy(H5T_C_S1), "copy string type");
    checked(H5Tset_size(type, H5T_VARIABLE), "set string length");
    checked(H5Tset_cset(type, H5T_CSET_UTF8), "set character set");
    return type;
}

struct FreeText
{
    void operator()(char* text) const { H5free_memory(text); }
};
using OwnedText = std::unique_ptr<char, FreeText>;

std::string text_of(hid_t place, char const* name)
{
    Attribute const attribute(H5Aopen(place, name, H5P_DEFAULT), "open attribute");
    Type const stored(H5Aget_type(attribute), "ask for a type");
    if (H5Tis_variable_str(stored) <= 0) {
        throw Failure(std::string(name) + " is no text");
    }
    char* text = nullptr;
    checked(H5Aread(attribute, text_type(), &text), "read attribute");
    OwnedText const owner(text);
    return text == nullptr ? std::string() : text;
}

int number_of(hid_t place, char const* name)
{
    int value = 0;
    Attribute const attribute(H5Aopen(place, name, H5P_DEFAULT), "open attribute");
    checked(H5Aread(attribute, H5T_NATIVE_INT, &value), "read attribute");
    return value;
}

/// A dataset of @p rank dimensions, whole.
struct Opened
{
    Opened(hid_t place, char const* name, std::size_t rank) : set(H5Dopen2(place, name, H5P_DEFAULT), "open dataset")
    {
        Space const space(H5Dget_space(set), "get dataspace");
        if (static_cast<std::size_t>(checked(H5Sget_simple_extent_ndims(space), "ask for the shape")) != rank) {
            throw Failure(std::string(name) + " has the wrong number of dimensions");
        }
        shape.resize(rank);
        checked(H5Sget_simple_extent_dims(space, shape.data(), nullptr), "ask for the shape");
    }
    [[nodiscard]] std::size_t count() const
    {
        std::size_t all = 1;
        for (auto const length : shape) {
            all *= static_cast<std::size_t>(length);
        }
        return all;
    }

    Dataset set;
    std::vector<hsize_t> shape;
};

template <class Value>
std::vector<Value> values_of(Opened const& opened, hid_t type)
{
    std::vector<Value> values(opened.count());
    if (!values.empty()) {
        checked(H5Dread(opened.set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), "read dataset");
    }
    return values;
}

std::vector<std::string> texts_of(hid_t place, char const* name)
{
    Opened const opened(place, name, 1);
    Type const stored(H5Dget_type(opened.set), "ask for a type");
    if (H5Tis_variable_str(stored) <= 0) {
        throw Failure(std::string(name) + " holds no texts");
    }
    std::vector<std::string> texts;
    for (char* const text : values_of<char*>(opened, text_type())) {
        OwnedText const owner(text);
        texts.emplace_back(text == nullptr ? "" : text);
    }
    return texts;
}

void require(bool holds, char const* cause)
{
    if (!holds) {
        throw Failure(cause);
    }
}

std::vector<OutlinePiece> pieces_of(hid_t place, std::size_t points)
{
    constexpr std::size_t list = 1;
    auto const kinds = texts_of(place, "pieces/kind"), segments = texts_of(place, "pieces/segment_name");
    auto const first = values_of<int>(Opened(place, "pieces/first", list), H5T_NATIVE_INT);
    auto const last = values_of<int>(Opened(place, "pieces/last", list), H5T_NATIVE_INT);
    require(segments.size() == kinds.size() && first.size() == kinds.size() && last.size() == kinds.size(), "lists of pieces differ in length");
    std::vector<OutlinePiece> pieces;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        require(first[i] >= 0 && last[i] >= first[i] && static_cast<std::size_t>(last[i]) < points, "a piece lies outside the outline");
        pieces.push_back({kinds[i], segments[i], static_cast<std::size_t>(first[i]), static_cast<std::size_t>(last[i])});
    }
    return pieces;
}

CircularSplineOutline outline_of(hid_t file)
{
    constexpr std::size_t list = 1, slices_points_coordinates = 3, plane = 2;
    Group const place(H5Gopen2(file, "circular_spline", H5P_DEFAULT), "open the circular spline");
    CircularSplineOutline result;
    result.z = values_of<double>(Opened(place, "z", list), H5T_NATIVE_DOUBLE);
    Opened const outline(place, "outline", slices_points_coordinates);
    auto const flat = values_of<double>(outline, H5T_NATIVE_DOUBLE);
    std::size_t const slices = static_cast<std::size_t>(outline.shape[0]), points = static_cast<std::size_t>(outline.shape[1]);
    require(outline.shape[2] == plane && slices == result.z.size() && slices > 0 && points > 0, "outline and z do not go together");
    for (double const value : flat) {
        require(std::isfinite(value), "a point of the outline is not finite");
    }
    for (std::size_t k = 0; k < slices; ++k) {
        auto& slice = result.outline.emplace_back();
        for (std::size_t i = 0; i < points; ++i) {
            std::size_t const at = plane * (k * points + i);
            slice.emplace_back(flat[at], flat[at + 1]);
        }
    }
    result.landmarks = values_of<int>(Opened(place, "landmarks", list), H5T_NATIVE_INT);
    for (int const landmark : result.landmarks) {
        require(landmark >= 0 && static_cast<std::size_t>(landmark) < points, "a landmark lies outside the outline");
    }
    result.pieces = pieces_of(place, points);
    return result;
}

}  // namespace

StoredOutline read_outline(std::filesystem::path const& file)
{
    Silence const silence;
    try {
        File const opened(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), "open the file");
        require(text_of(opened, "format") == "hdconj", "it is of another program");
        require(number_of(opened, "format_version") <= newest_format, "it was written by a newer version");
        return {text_of(opened, "scene"), outline_of(opened)};
    } catch (Failure const& failure) {
        throw FileError(file, std::string("is no result file of hdconj: ") + failure.what() + " (make one: hdconj solve -o FILE.h5)");
    }
}

}  // namespace hdconj
