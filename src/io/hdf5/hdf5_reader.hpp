// SPDX-License-Identifier: GPL-3.0-or-later
// Reads attributes and datasets of an open HDF5 file.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <numeric>
#include <string>
#include <type_traits>
#include <vector>

#include "checksum.hpp"
#include "hdconj/error.hpp"
#include "hdf5_handle.hpp"
#include "io/layout/stored_group.hpp"

namespace hdconj::io::hdf5 {

using layout::Misfit;
using layout::require;

using OwnedText = std::unique_ptr<char, herr_t (*)(void*)>;

inline std::string text_of(hid_t place, char const* name)
{
    Attribute const attribute(H5Aopen(place, name, H5P_DEFAULT), "open attribute");
    Type const stored(H5Aget_type(attribute), "ask for a type");
    if (H5Tis_variable_str(stored) <= 0)
        throw Misfit(std::string(name) + " is no text");
    char* text = nullptr;
    checked(H5Aread(attribute, text_type(), &text), "read attribute");
    OwnedText const owner(text, &H5free_memory);
    return text == nullptr ? std::string() : text;
}

template <class Number = int>
Number number_of(hid_t place, char const* name)
{
    Number value = 0;
    Attribute const attribute(H5Aopen(place, name, H5P_DEFAULT), "open attribute");
    checked(H5Aread(attribute, std::is_same_v<Number, int> ? H5T_NATIVE_INT : H5T_NATIVE_DOUBLE, &value),
            "read attribute");
    return value;
}

/// A dataset of @p rank dimensions, whole.
struct Opened
{
    Opened(hid_t place, char const* name, std::size_t rank) : set(H5Dopen2(place, name, H5P_DEFAULT), "open dataset")
    {
        Space const space(H5Dget_space(set), "get dataspace");
        if (static_cast<std::size_t>(checked(H5Sget_simple_extent_ndims(space), "ask for the shape")) != rank)
            throw Misfit(std::string(name) + " has the wrong number of dimensions");
        shape.resize(rank);
        checked(H5Sget_simple_extent_dims(space, shape.data(), nullptr), "ask for the shape");
    }
    [[nodiscard]] std::size_t count() const
    {
        return std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>());
    }

    Dataset set;
    std::vector<hsize_t> shape;
};

template <class Value>
std::vector<Value> values_of(Opened const& opened, hid_t type)
{
    std::vector<Value> values(opened.count());
    if (!values.empty())
        checked(H5Dread(opened.set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), "read dataset");
    return values;
}

inline std::vector<std::string> texts_of(hid_t place, char const* name)
{
    Opened const opened(place, name, 1);
    Type const stored(H5Dget_type(opened.set), "ask for a type");
    if (H5Tis_variable_str(stored) <= 0)
        throw Misfit(std::string(name) + " holds no texts");
    std::vector<std::string> texts;
    for (char* const text : values_of<char*>(opened, text_type())) {
        OwnedText const owner(text, &H5free_memory);
        texts.emplace_back(text == nullptr ? "" : text);
    }
    return texts;
}

/// What keeps a file from being opened; empty: nothing.
inline std::string why_unreadable(std::filesystem::path const& file)
{
    std::error_code error;
    if (!std::filesystem::exists(file, error))
        return "there is no such file";
    if (std::filesystem::is_directory(file, error))
        return "it is a folder";
    if (::access(file.c_str(), R_OK) != 0)
        return "it may not be read (permissions)";
    if (H5Fis_hdf5(file.c_str()) <= 0)
        return "it is no HDF5 file";
    return is_damaged(file) ? "it is damaged: its bytes do not fit its checksum" : std::string();
}

/// A file of a user's as input.
struct StoredKind
{
    char const* what;       ///< "no result file of hdconj"
    char const* remedy;     ///< "make one: ..."
    char const* in_folder;  ///< name of such a file in a folder of results; null: in none
};

/// What @p read makes of the opened file. @throws InputError where @p file is not of that kind, or damaged
template <class Read>
auto read_stored(std::filesystem::path const& file, StoredKind const& kind, Read const& read)
{
    Silence const silence;
    auto const refuse = [&](std::string const& why, std::string const& remedy) {
        throw InputError(Fault{file.string(), 0, "", std::string("is ") + kind.what + ": " + why, remedy});
    };
    if (std::string const why = why_unreadable(file); !why.empty()) {
        std::error_code error;
        bool const folder = kind.in_folder != nullptr && std::filesystem::is_directory(file, error);
        refuse(why, folder ? "write " + (file / kind.in_folder).string() : kind.remedy);
    }
    std::string why;
    try {
        File const opened(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), "open the file");
        return read(opened);
    } catch (Misfit const& misfit) {
        why = misfit.what();
    } catch (Failure const&) {
        why = "parts of it are missing or damaged";
    }
    refuse(why, kind.remedy);
    throw Failure(why);  // not reached
}

}  // namespace hdconj::io::hdf5
