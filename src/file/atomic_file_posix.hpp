// SPDX-License-Identifier: GPL-3.0-or-later
// File descriptors and error texts for the atomic writer; private to src/io.
#pragma once

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace hdconj::file::posix {

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
    std::string const text = "cannot write: " + words(error);
    if (error == ENOSPC || error == EDQUOT)
        return text + " (free some space or write to another folder)";
    return error == EFBIG ? text + " (the limit on file size is reached, see `ulimit -f`)" : text;
}

/// Hands @p bytes piece by piece to @p take, which returns how many it took, or -1; an interrupted call is made again.
/// @returns 0, or the system's error number
template <class Take>
int in_pieces(std::string_view bytes, Take take)
{
    while (!bytes.empty()) {
        ssize_t const taken = take(bytes);
        if (taken < 0 && errno != EINTR)
            return errno;
        bytes.remove_prefix(taken < 0 ? 0 : static_cast<std::size_t>(taken));
    }
    return 0;
}

/// Where the last write ended. @returns 0, or the system's error number
inline int write_on(int descriptor, std::string_view bytes)
{
    return in_pieces(bytes, [&](std::string_view rest) { return ::write(descriptor, rest.data(), rest.size()); });
}

/// At a place of the file [bytes from its beginning]. @returns 0, or the system's error number
inline int write_at(int descriptor, std::size_t at, std::string_view bytes)
{
    std::size_t const end = at + bytes.size();
    return in_pieces(bytes, [&](std::string_view rest) {
        return ::pwrite(descriptor, rest.data(), rest.size(), static_cast<off_t>(end - rest.size()));
    });
}

/// What can be read: @p bytes is left as it was behind the end of the file and from an error on.
inline void read_at(int descriptor, std::size_t at, std::size_t size, char* bytes)
{
    while (size > 0) {
        ssize_t const given = ::pread(descriptor, bytes, size, static_cast<off_t>(at));
        if (given < 0 && errno == EINTR)
            continue;
        if (given <= 0)
            return;
        bytes += given;
        at += static_cast<std::size_t>(given);
        size -= static_cast<std::size_t>(given);
    }
}

/// The disk begins to take this part in, and whoever waits for the whole file has less to wait for. Where the system
/// has no such call: nothing.
inline void begin_to_store(int descriptor, std::size_t at, std::size_t size)
{
#ifdef SYNC_FILE_RANGE_WRITE
    (void)::sync_file_range(descriptor, static_cast<off_t>(at), static_cast<off_t>(size),
                            SYNC_FILE_RANGE_WRITE);  // not needed: fsync() comes
#else
    (void)descriptor, (void)at, (void)size;
#endif
}

/// Cuts the file, or fills it with zeros. @returns 0, or the system's error number
inline int end_at(int descriptor, std::size_t size)
{
    return ::ftruncate(descriptor, static_cast<off_t>(size)) == 0 ? 0 : errno;
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
    if (::stat(path.c_str(), &status) == 0)
        return {status, 0};
    return {std::nullopt, errno == ENOENT || errno == ENOTDIR ? 0 : errno};
}

/// A descriptor that is closed on every way out.
class Descriptor
{
  public:
    Descriptor(std::filesystem::path const& file, int flags)
        : number_(::open(file.c_str(), flags | O_CLOEXEC, new_file_mode))
    {
    }
    ~Descriptor()
    {
        if (is_open())
            ::close(number_);
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

/// Writes a whole file, opened for writing with @p flags besides. @returns 0, or the system's error number
inline int write_whole(std::filesystem::path const& file, int flags, std::string_view bytes)
{
    Descriptor out(file, O_WRONLY | flags);
    if (!out.is_open())
        return errno;
    int const written = write_on(out.number(), bytes);
    int const closed = out.close();
    return written != 0 ? written : closed;
}

}  // namespace hdconj::file::posix
