// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Reads attributes and datasets of an open HDF5 file; private to src/io.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "hdf5_handle.hpp"

namespace hdconj::hdf5 {

inline Type text_type()
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

inline std::string text_of(hid_t place, char const* name)
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

inline int number_of(hid_t place, char const* name)
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

inline std::vector<std::string> texts_of(hid_t place, char const* name)
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

inline void require(bool holds, char const* cause)
{
    if (!holds) {
        throw Failure(cause);
    }
}

}  // namespace hdconj::hdf5
