// SPDX-License-Identifier: GPL-3.0-or-later
// A file that a verb has written.
#pragma once

#include <filesystem>
#include <string>

namespace hdconj {

/// A file that was written, for the summaries.
struct WrittenFile
{
    std::string kind;            ///< "hdf5", "dxf", "picture" ...; one file of each kind
    std::filesystem::path file;  ///< as the user gave it
    double seconds = 0;          ///< time to make and write it
};

}  // namespace hdconj
