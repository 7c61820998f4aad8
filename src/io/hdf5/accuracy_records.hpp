// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Records of a study as the bytes of an HDF5 file.
#pragma once

#include <string>

#include "hdconj/accuracy_files.hpp"

namespace hdconj::io {

/// @throws hdf5::Failure
[[nodiscard]] std::string accuracy_bytes(StoredAccuracy const& study);

/// The drive whose records @p file holds. @throws InputError as read_accuracy() does
[[nodiscard]] std::string stored_drive(std::filesystem::path const& file);

}  // namespace hdconj::io
