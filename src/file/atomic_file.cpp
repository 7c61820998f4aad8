// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/file/atomic_file.hpp"

#include "atomic_file_posix.hpp"
#include "temporary_path.hpp"

namespace hdconj::file {
namespace fs = std::filesystem;

namespace {

fs::path folder_of(fs::path const& target)
{
    return target.has_parent_path() ? target.parent_path() : fs::path(".");
}

/// The file that a symbolic link stands for, so that the link survives the rename.
fs::path resolved(fs::path const& target)
{
    std::error_code error;
    if (!fs::is_symlink(target, error))
        return target;
    fs::path real = fs::weakly_canonical(target, error);
    return error ? target : real;
}

/// Writes all of @p text into @p file, opened with @p flags besides; @p blamed is the name in messages.
void write_all(fs::path const& file, int flags, std::string_view text, fs::path const& blamed)
{
    if (int const error = posix::write_whole(file, flags, text); error != 0)
        throw FileError(blamed, posix::cannot_write(error));
}

/// Puts the content on the disk before its name does: after a power cut the target must not be empty.
void flush(fs::path const& file, posix::Status const& old, fs::path const& blamed)
{
    posix::Descriptor const written(file, O_RDONLY);
    // EINVAL: a file system without fsync
    if (!written.is_open() || (::fsync(written.number()) != 0 && errno != EINVAL))
        throw FileError(blamed, posix::cannot_write(errno));
    if (old.is_file())
        ::fchmod(written.number(), old.found->st_mode & ACCESSPERMS);  // a courtesy: may fail on foreign disks
}

}  // namespace

void check_target(fs::path const& target)
{
    if (target.empty())
        throw FileError("(empty name)", "no file name given");
    fs::path const real = resolved(target);
    fs::path const folder = folder_of(real);
    posix::Status const status = posix::status_of(real);
    posix::Status const around = posix::status_of(folder);
    if (status.error != 0)
        throw FileError(target, posix::cannot_write(status.error));
    if (status.is_folder() || !target.has_filename())
        throw FileError(target, "is a folder", "write a file name in it");
    if (!around.found) {
        throw FileError(target, "the folder " + folder.string() + " does not exist",
                        "create it: mkdir -p '" + folder.string() + "'");
    }
    if (!around.is_folder())
        throw FileError(target, folder.string() + " is not a folder");
    if (status.found && ::access(real.c_str(), W_OK) != 0)
        throw FileError(target, "is write-protected: " + posix::words(errno));
    if (!status.is_device() && ::access(folder.c_str(), W_OK | X_OK) != 0)
        throw FileError(target, "the folder " + folder.string() + " cannot be written: " + posix::words(errno));
}

void write_atomically(fs::path const& target, std::function<void(fs::path const&)> const& write)
{
    check_target(target);
    fs::path const real = resolved(target);
    posix::Status const old = posix::status_of(real);
    if (old.is_device()) {
        write(real);
        return;
    }
    TemporaryPath const temporary(real);
    write_all(temporary.name(), O_CREAT | O_EXCL, "", target);
    write(temporary.name());
    flush(temporary.name(), old, target);
    if (int const error = temporary.rename_to(real); error != 0)
        throw FileError(target, posix::cannot_write(error));
}

void write_text_atomically(fs::path const& target, std::string_view text)
{
    write_atomically(target, [&](fs::path const& file) { write_all(file, 0, text, target); });
}

}  // namespace hdconj::file
