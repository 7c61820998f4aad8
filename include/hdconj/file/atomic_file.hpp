// SPDX-License-Identifier: GPL-3.0-or-later
// Write-then-rename: a file is either the old one or the new one, never half of one.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

#include "hdconj/error.hpp"

namespace hdconj::file {

/// Refuses a target that cannot be written: a folder, or in a folder that is missing or not writable, or a name
/// that is too long. For use before long work; a target that passes may still fail later (disk full).
/// @throws FileError
void check_target(std::filesystem::path const& target);

/// The temporary name that @ref write_atomically uses: `.NAME.hdconj-PID-HOST.tmp` beside @p target, NAME cut where the
/// whole would be longer than a file name may be. What a killed process has left is removed by the next write into that
/// folder from the same machine.
[[nodiscard]] std::filesystem::path temporary_name(std::filesystem::path const& target);

/// From now on SIGHUP, SIGINT and SIGTERM remove all temporary files and folders of this process before they end it.
/// For programs; a library leaves signals to its host.
void remove_temporaries_when_interrupted();

/// Calls @p write with the name of a temporary file in the same folder, flushes it to disk and renames it to
/// @p target. On any failure the temporary file is removed and @p target is left as it was. The permissions of an
/// existing target are kept, a symbolic link is followed.
/// Devices and pipes (such as /dev/stdout) cannot be renamed to: they are written directly.
/// One thread at a time per target.
/// @throws FileError; exceptions of @p write pass through
void write_atomically(std::filesystem::path const& target,
                      std::function<void(std::filesystem::path const&)> const& write);

/// The same for content that is ready: text, or bytes.
void write_text_atomically(std::filesystem::path const& target, std::string_view text);

}  // namespace hdconj::file
