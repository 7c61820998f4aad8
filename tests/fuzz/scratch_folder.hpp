// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Where a target puts the files that a scene names: one folder for the process.
#pragma once

#include <filesystem>
#include <fstream>
#include <string_view>

#include "support/temporary_folder.hpp"

namespace hdconj::fuzz {

/// The folder, with the data files of data/scenes in it.
inline std::filesystem::path const& scratch_folder()
{
    static test::TemporaryFolder const folder;
    [[maybe_unused]] static bool const filled = [] {
        for (auto const& entry : std::filesystem::directory_iterator(HDCONJ_SOURCE_DIR "/data/scenes")) {
            if (entry.path().extension() != ".toml")
                std::filesystem::copy(entry.path(), folder.path(), std::filesystem::copy_options::recursive);
        }
        return true;
    }();
    return folder.path();
}

inline void write_scratch(std::filesystem::path const& name, std::string_view content)
{
    std::ofstream(scratch_folder() / name.filename(), std::ios::binary) << content;
}

}  // namespace hdconj::fuzz
