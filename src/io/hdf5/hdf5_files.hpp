// SPDX-License-Identifier: GPL-3.0-or-later
// Records of a study as an HDF5 file, whole.
#pragma once

#include <filesystem>
#include <string>

#include "hdf5_handle.hpp"
#include "io/layout/results.hpp"

namespace hdconj::io::hdf5 {

/// Records of a study as the bytes of a file. @throws Failure
[[nodiscard]] std::string accuracy_bytes(StoredAccuracy const& study);

/// The drive whose records @p file holds. @throws InputError as read_accuracy() does
[[nodiscard]] std::string stored_drive(std::filesystem::path const& file);

}  // namespace hdconj::io::hdf5
