// SPDX-License-Identifier: GPL-3.0-or-later
// The hidden file or folder beside a target that becomes the target by a rename.
#pragma once

#include <filesystem>

namespace hdconj::file {

/// Owns the name temporary_name() of a target. What stands under that name is removed by the destructor, and, if the
/// program has asked for it (remove_temporaries_when_interrupted), by a signal that ends the process.
class TemporaryPath
{
  public:
    /// Removes what is left under this name, and everything in the target's folder that processes of this machine have
    /// left when they were killed.
    explicit TemporaryPath(std::filesystem::path const& target);
    ~TemporaryPath();
    TemporaryPath(TemporaryPath const&) = delete;
    TemporaryPath& operator=(TemporaryPath const&) = delete;

    [[nodiscard]] std::filesystem::path const& name() const { return name_; }

    /// Renames it to @p target, with the flags of renameat2(). A signal that removes temporaries comes before or after:
    /// in the midst of it, it would remove files of what has just become the target.
    /// @returns 0, or the system's error number
    [[nodiscard]] int rename_to(std::filesystem::path const& target, unsigned int flags = 0) const;

  private:
    std::filesystem::path name_;
};

}  // namespace hdconj::file
