// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Reads datasets of a result file.
#pragma once

#include <filesystem>
#include <vector>

#include "io/hdf5/hdf5_handle.hpp"

namespace hdconj::test {

/// Dimensions and numbers of a dataset.
struct Read
{
    std::vector<hsize_t> shape;
    std::vector<double> values;
};

inline Read read(hid_t file, char const* name)
{
    io::hdf5::Dataset const dataset(H5Dopen2(file, name, H5P_DEFAULT), "open");
    io::hdf5::Space const space(H5Dget_space(dataset), "space");
    Read result;
    result.shape.resize(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
    H5Sget_simple_extent_dims(space, result.shape.data(), nullptr);
    result.values.resize(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
    if (!result.values.empty()) {
        io::hdf5::checked(H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, result.values.data()),
                          "read");
    }
    return result;
}

inline bool has_link(hid_t file, char const* name)
{
    return H5Lexists(file, name, H5P_DEFAULT) > 0;
}

inline io::hdf5::File open_file(std::filesystem::path const& file)
{
    return {H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), "open"};
}

}  // namespace hdconj::test
