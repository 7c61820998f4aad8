// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/file/atomic_file.hpp"

#include <climits>
#include <utility>

#include "atomic_file_posix.hpp"
#include "hdconj/error.hpp"

namespace hdconj::file {
namespace fs = std::filesystem;
using namespace posix;

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

/// Writes all of @p text into the existing @p file; @p blamed is the name in messages.
void write_all(fs::path const& file, std::string_view text, fs::path const& blamed)
{
    posix::Descriptor out(file, O_WRONLY);
    if (!out.is_open())
        throw FileError(blamed, posix::cannot_write(errno));
    int const written = posix::write_on(out.number(), text);
    int const closed = out.close();
    if (int const error = written != 0 ? written : closed; error != 0)
        throw FileError(blamed, posix::cannot_write(error));
}

/// Removes the temporary file unless it has been renamed.
class Temporary
{
  public:
    Temporary(fs::path name, fs::path const& target) : name_(std::move(name)), target_(target)
    {
        ::unlink(name_.c_str());  // left over by a killed process that had this process id
        posix::Descriptor const made(name_, O_WRONLY | O_CREAT | O_EXCL);
        if (!made.is_open())
            throw FileError(target_, posix::cannot_write(errno));
    }
    ~Temporary()
    {
        if (!name_.empty())
            ::unlink(name_.c_str());
    }
    Temporary(Temporary const&) = delete;
    Temporary& operator=(Temporary const&) = delete;

    [[nodiscard]] fs::path const& name() const { return name_; }

    /// Puts the content on the disk before its name does: after a power cut the target must not be empty.
    void flush(posix::Status const& old) const
    {
        posix::Descriptor const written(name_, O_RDONLY);
        if (!written.is_open())
            throw FileError(target_, posix::cannot_write(errno));
        if (::fsync(written.number()) != 0 && errno != EINVAL) {  // EINVAL: a file system without fsync
            throw FileError(target_, posix::cannot_write(errno));
        }
        if (old.is_file()) {
            ::fchmod(written.number(), old.found->st_mode & ACCESSPERMS);  // a courtesy: may fail on foreign disks
        }
    }

    void rename_to(fs::path const& real)
    {
        if (::rename(name_.c_str(), real.c_str()) != 0)
            throw FileError(target_, posix::cannot_write(errno));
        name_.clear();
    }

  private:
    fs::path name_;
    fs::path target_;
};

}  // namespace

fs::path temporary_name(fs::path const& target)
{
    std::string name = target.filename().string();
    std::string const ending = ".hdconj-" + std::to_string(::getpid()) + ".tmp";
    std::size_t cut = NAME_MAX - ending.size() - 1;
    if (name.size() > cut) {
        constexpr unsigned char continues = 0x80, mask = 0xC0;  // do not cut a UTF-8 character in half
        while (cut > 0 && (static_cast<unsigned char>(name[cut]) & mask) == continues)
            --cut;
        name.resize(cut);
    }
    return folder_of(target) / ("." + name + ending);
}

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
        throw FileError(target, "is a folder (write a file name in it)");
    if (!around.found) {
        throw FileError(target, "the folder " + folder.string() + " does not exist (create it: mkdir -p '" +
                                    folder.string() + "')");
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
    Temporary temporary(temporary_name(real), target);
    write(temporary.name());
    temporary.flush(old);
    temporary.rename_to(real);
}

void write_text_atomically(fs::path const& target, std::string_view text)
{
    write_atomically(target, [&](fs::path const& file) { write_all(file, text, target); });
}

}  // namespace hdconj::file
