// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What verbs that write files share: names, checks before the long work, progress on a terminal.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "hdconj/io/result_files.hpp"
#include "hdconj/scene/scene.hpp"

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

/// What is read by an option; nothing where it is not given.
[[nodiscard]] std::vector<InputFile> input_of(std::string const& option, std::string const& file);

/// One file, or one family of files, to write.
struct OutputJob
{
    std::string kind;             ///< "hdf5", "dxf", "picture"
    std::string option;           ///< for messages
    std::filesystem::path file;
    std::function<void()> check;  ///< what can be known about the target before the long work; throws
    std::vector<std::filesystem::path> members{};  ///< files that are written beside or in place of it
    bool is_folder = false;  ///< all that lies in it is replaced
};

/// Everything about the targets that can be known before the long work.
/// @param read  files that no result may replace
/// @throws InputError, FileError
void check_outputs(std::vector<OutputJob> const& jobs, std::vector<InputFile> const& read);

/// A file name made of a drive's name: letters of any script, digits, and "._-" stay.
[[nodiscard]] std::string file_name(std::string const& drive);

/// Runs @p write and keeps its time.
[[nodiscard]] WrittenFile timed(std::string const& kind, std::filesystem::path const& file, std::function<void()> const& write);

/// What a verb with several cases ends with: done, or failed where some are @p missing, which is said on standard error.
/// @param written  cases that were computed, and are written by now
[[nodiscard]] int status_of_cases(std::vector<std::string> const& missing, std::size_t written);

/// On a terminal, names the stage that runs, over and over in one line; where nobody looks it says nothing.
class Progress
{
  public:
    explicit Progress(bool wanted);
    ~Progress() { clear(); }
    Progress(Progress const&) = delete;
    Progress& operator=(Progress const&) = delete;

    void say(std::string const& what) const;
    /// The same with a bar; @p share 0 ... 1.
    void say(std::string const& what, double share) const;
    /// A line that stays on the screen.
    void keep(std::string const& line) const;
    void clear() const;

  private:
    bool shown_;
};

}  // namespace hdconj::cli
