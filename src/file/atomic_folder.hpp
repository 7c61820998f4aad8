// SPDX-License-Identifier: GPL-3.0-or-later
// A folder of files that appears whole or not at all, as write_atomically() does for one file; private to src/io.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "temporary_path.hpp"

namespace hdconj::file {

/// Files are written into a hidden folder beside the target; publish() renames it. A folder that was published before,
/// and holds nothing but its own files, is exchanged for the new one. Whatever is left unpublished is removed.
class AtomicFolder
{
  public:
    /// What a folder holds, as the first line of its list of files: only one with the same is exchanged.
    static constexpr char const* wire_program = "hdconj wire program: the files of this folder";
    static constexpr char const* calculix_deck = "hdconj CalculiX deck: the files of this folder";
    static constexpr char const* accuracy_study = "hdconj accuracy study: the files of this folder";

    /// What can be known before: @throws FileError where the folder cannot be made or holds other files
    static void check(std::filesystem::path const& target, char const* first_line);

    explicit AtomicFolder(std::filesystem::path const& target, char const* first_line);

    /// @throws FileError, named after where the file is going to be
    void write(std::string const& name, std::string const& text) const;
    [[nodiscard]] std::string read(std::string const& name) const;

    /// Adds the list of files, puts everything on the disk and renames.
    /// @param lines  of the list: name, and what is to be said about the file
    void publish(std::vector<std::pair<std::string, std::string>> const& lines);

    /// Name of the list of files.
    static constexpr char const* list_name = "files.txt";

  private:
    char const* first_line_;
    std::filesystem::path target_;
    TemporaryPath made_;  ///< after publish() the folder that was there before, if any
};

}  // namespace hdconj::file
