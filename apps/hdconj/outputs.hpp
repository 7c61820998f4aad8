// SPDX-License-Identifier: GPL-3.0-or-later
// Files that verbs write: their names, and what is checked of them before the long work.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "hdconj/error.hpp"
#include "hdconj/scene.hpp"

namespace hdconj::cli {

struct CommonOptions;

/// A file that is read, which no result may replace.
struct InputFile
{
    std::filesystem::path file;
    std::string what;  ///< "this is the scene file", "this file is read by --measured"
};

/// The files that @p scene was read from: its own, and those that its keys name.
[[nodiscard]] std::vector<InputFile> inputs_of(CommonOptions const& common, Scene const& scene);

/// The file that @p option names; none where it is not given.
[[nodiscard]] std::vector<InputFile> input_of(std::string const& option, std::string const& file);

/// One file, or one family of files, that is to be written.
struct OutputTarget
{
    std::string kind;    ///< "hdf5", "dxf", "picture"
    std::string option;  ///< for messages
    std::filesystem::path file;
    std::function<void()> check;                   ///< what can be known about the target before the long work; throws
    std::vector<std::filesystem::path> members{};  ///< files that are written beside or in place of it
    bool is_folder = false;                        ///< all that lies in it is replaced
};

/// Everything about the targets that can be known before the long work.
/// @param read    files that no result may replace
/// @param faults  that were found before
/// @throws InputError with all faults; FileError where there is none
void check_outputs(std::vector<OutputTarget> const& targets, std::vector<InputFile> const& read, Faults faults);

/// A check of a target of @p option, whose name must end in @p ending: check_target(), and that.
/// @param reader  that knows the file by it
[[nodiscard]] std::function<void(std::filesystem::path const&)> check_ending(std::string option, std::string ending,
                                                                             std::string reader);

/// A file name made of a drive's name: letters of any script, digits, and "._-" stay.
[[nodiscard]] std::string file_name(std::string const& drive);

/// @p given, or where it is empty the name of the scene file without its ending, and @p ending; a scene that is no file
/// has the name of its drive.
[[nodiscard]] std::filesystem::path output_name(CommonOptions const& common, std::string const& given,
                                                Scene const& scene, std::string const& ending);

}  // namespace hdconj::cli
