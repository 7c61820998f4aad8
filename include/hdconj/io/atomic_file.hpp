// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Write-then-rename: a file is either the old one or the new one, never half of one.
#pragma once

#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace hdconj {

/// A file could not be read or written (exit status 1).
class FileError : public std::runtime_error
{
  public:
    FileError(std::filesystem::path const& file, std::string const& cause)
        : std::runtime_error(file.string() + ": " + cause)
    {
    }
};

/// Calls @p write with the name of a temporary file in the same folder, flushes it to disk and renames it to
/// @p target. On any failure the temporary file is removed and @p target is left as it was.
/// Devices and pipes (such as /dev/stdout) cannot be renamed to: they are written directly.
/// @throws FileError; exceptions of @p write pass through
void write_atomically(std::filesystem::path const& target,
                      std::function<void(std::filesystem::path const&)> const& write);

/// The same for a text that is ready.
void write_text_atomically(std::filesystem::path const& target, std::string_view text);

}  // namespace hdconj
