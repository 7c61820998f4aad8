// SPDX-License-Identifier: GPL-3.0-or-later
#include "atomic_folder.hpp"

#include <stdio.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "atomic_file_posix.hpp"
#include "hdconj/error.hpp"
#include "hdconj/file/atomic_file.hpp"

namespace hdconj::file {
namespace fs = std::filesystem;

namespace {

fs::path without_slash(fs::path const& target)
{
    return target.has_filename() ? target : target.parent_path();
}

/// The folder that is meant: a link to a folder stands for that folder.
fs::path real_folder(fs::path const& target)
{
    std::error_code error;
    fs::path const real = fs::weakly_canonical(fs::absolute(without_slash(target), error), error);
    return error ? without_slash(target) : real;
}

/// What the list of files of @p folder says that it holds; empty where there is no list of hdconj's.
std::string held_result(fs::path const& folder)
{
    std::ifstream in(folder / AtomicFolder::list_name);
    std::string line;
    return std::getline(in, line) && line.starts_with("hdconj ") ? line : std::string();
}

/// Names in the list of files of @p folder; empty where there is none with that first line.
std::vector<std::string> listed(fs::path const& folder, char const* first_line)
{
    std::ifstream in(folder / AtomicFolder::list_name);
    std::vector<std::string> names;
    std::string line;
    if (std::getline(in, line) && line == first_line) {
        names.emplace_back(AtomicFolder::list_name);
        while (std::getline(in, line))
            names.push_back(line.substr(0, line.find(' ')));
    }
    return names;
}

/// A file in @p folder that is not ours; empty: none.
std::string foreign_file(fs::path const& folder, char const* first_line)
{
    auto const ours = listed(folder, first_line);
    std::error_code error;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
        std::string name = at->path().filename().string();
        if (std::find(ours.begin(), ours.end(), name) == ours.end())
            return name;
    }
    return {};
}

void flush(fs::path const& name, fs::path const& blamed)
{
    posix::Descriptor const file(name, O_RDONLY);
    if (!file.is_open() || (::fsync(file.number()) != 0 && errno != EINVAL))
        throw FileError(blamed, posix::cannot_write(errno));
}

}  // namespace

void AtomicFolder::check(fs::path const& target, char const* first_line)
{
    if (target.empty())
        throw FileError("(empty name)", "no folder name given");
    fs::path const real = real_folder(target);
    if (!real.has_filename())
        throw FileError(target, "is no folder that could be made", "write the name of a new one");
    posix::Status const status = posix::status_of(real);
    if (status.error != 0)
        throw FileError(target, posix::cannot_write(status.error));
    if (status.found && !status.is_folder())
        throw FileError(target, "is a file, not a folder", "write the name of a new folder");
    // Also where the folder is there already: a new one is made beside it.
    check_target(status.found ? real.parent_path() / ("." + real.filename().string() + ".new") : without_slash(target));
    if (status.is_folder()) {
        if (std::string const name = foreign_file(real, first_line); !name.empty()) {
            std::string const held = held_result(real);
            bool const of_another_kind = !held.empty() && held != first_line;
            throw FileError(target,
                            of_another_kind ? "holds another kind of result, \"" + held + "\""
                                            : "holds " + name + ", which hdconj did not write there",
                            "write the name of a new folder");
        }
    }
}

AtomicFolder::AtomicFolder(fs::path const& target, char const* first_line)
    : first_line_(first_line), target_(real_folder(target)), made_(target_)
{
    check(target, first_line_);
    std::error_code error;
    if (!fs::create_directory(made_.name(), error) || error)
        throw FileError(target, posix::cannot_write(error.value()));
}

void AtomicFolder::write(std::string const& name, std::string const& text) const
{
    if (int const error = posix::write_whole(made_.name() / name, O_CREAT | O_EXCL, text); error != 0)
        throw FileError(target_ / name, posix::cannot_write(error));
}

std::string AtomicFolder::read(std::string const& name) const
{
    std::ifstream in(made_.name() / name, std::ios::binary);
    std::ostringstream all;
    all << in.rdbuf();
    if (!in || !all)
        throw FileError(target_ / name, "cannot be read back");
    return all.str();
}

void AtomicFolder::publish(std::vector<std::pair<std::string, std::string>> const& lines)
{
    std::string list = std::string(first_line_) + "\n";
    for (auto const& [name, said] : lines)
        list += name + " " + said + "\n";
    write(list_name, list);
    for (auto const& entry : fs::directory_iterator(made_.name()))
        flush(entry.path(), target_ / entry.path().filename());
    flush(made_.name(), target_);
    check(target_, first_line_);  // again: something may have been put there while the work went on
    bool const there = posix::status_of(target_).is_folder();
    unsigned int const how = there ? RENAME_EXCHANGE : RENAME_NOREPLACE;
    int error = made_.rename_to(target_, how);
    if (!there && error == EINVAL)  // a file system that knows no such flags
        error = made_.rename_to(target_);
    if (error != 0) {
        throw FileError(target_, there && error == EINVAL
                                     ? "this file system cannot exchange folders (remove the old one first)"
                                     : posix::cannot_write(error));
    }
}

}  // namespace hdconj::file
