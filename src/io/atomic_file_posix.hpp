// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// File descriptors and error texts for the atomic writer; private to src/io.
#pragma once

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>

namespace hdconj::posix {

/// Permissions asked for a new file; the umask takes its share.
inline constexpr mode_t new_file_mode = 0666;

/// The system's words for an error number.
inline std::string words(int error)
{
    return std::generic_category().message(error);
}

/// Cause and remedy of a failed write.
inline std::string cannot_write(int error)
{
    std::string text = "cannot write: " + words(error);
    if (error == ENOSPC || error == EDQUOT) {
        text += " (free some space or write to another folder)";
    } else if (error == EFBIG) {
        text += " (the limit on file size is reached, see `ulimit -f`)";
    }
    return text;
}

/// What stat() says about a path.
struct Status
{
    std::optional<struct stat> found;  ///< nothing when there is no such file
    int error = 0;                     ///< why there is nothing; 0 when it merely does not exist

    [[nodiscard]] bool is_folder() const { return found && S_ISDIR(found->st_mode); }
    [[nodiscard]] bool is_file() const { return found && S_ISREG(found->st_mode); }
    /// Something to be written directly: a device, a pipe, a socket.
    [[nodiscard]] bool is_device() const { return found && !is_folder() && !is_file(); }
};

inline Status status_of(std::filesystem::path const& path)
{
    struct stat status = {};
    if (::stat(path.c_str(), &status) == 0) {
        return {status, 0};
    }
    return {std::nullopt, errno == ENOENT || errno == ENOTDIR ? 0 : errno};
}

/// A descriptor that is closed on every way out.
class Descriptor
{
  public:
    Descriptor(std::filesystem::path const& file, int flags) : number_(::open(file.c_str(), flags | O_CLOEXEC, new_file_mode)) {}
    ~Descriptor()
    {
        if (is_open()) {
            ::close(number_);
        }
    }
    Descriptor(Descriptor const&) = delete;
    Descriptor& operator=(Descriptor const&) = delete;

    [[nodiscard]] bool is_open() const { return number_ >= 0; }
    [[nodiscard]] int number() const { return number_; }

    /// Closes and returns the error number, 0 for none: network file systems report a full disk here.
    int close()
    {
        int const error = ::close(number_) == 0 ? 0 : errno;
        number_ = -1;
        return error;
    }

  private:
    int number_;
};

}  // namespace hdconj::posix
