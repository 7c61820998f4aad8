// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture_gnuplot.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <system_error>

extern char** environ;

namespace hdconj::gnuplot {
namespace {

constexpr std::size_t block = std::size_t{1} << 16;

[[noreturn]] void fail(int error)
{
    throw std::runtime_error(error == ENOENT ? missing
                                             : "cannot run gnuplot: " + std::generic_category().message(error));
}

struct CloseFile
{
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using NamelessFile = std::unique_ptr<std::FILE, CloseFile>;

/// A temporary file without a name: gone with the process, whatever becomes of it.
NamelessFile nameless(std::string const& content)
{
    NamelessFile file(std::tmpfile());
    if (!file) {
        fail(errno);
    }
    if (std::fwrite(content.data(), 1, content.size(), file.get()) != content.size() || std::fflush(file.get()) != 0) {
        fail(errno);
    }
    std::rewind(file.get());
    return file;
}

/// Reads to the end of @p source.
std::string drain(int source)
{
    std::string all;
    std::array<char, block> buffer;
    for (;;) {
        ssize_t const count = ::read(source, buffer.data(), buffer.size());
        if (count > 0) {
            all.append(buffer.data(), static_cast<std::size_t>(count));
        } else if (count == 0 || errno != EINTR) {
            return all;
        }
    }
}

/// Starts gnuplot without the user's settings, so that pictures look the same everywhere.
pid_t start(int script, int drawing, int complaints)
{
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, script, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, drawing, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, complaints, STDERR_FILENO);
    std::string name = "gnuplot", defaults = "--default-settings", standard_input = "-";
    std::array<char*, 4> arguments = {name.data(), defaults.data(), standard_input.data(), nullptr};
    pid_t child = 0;
    int const error = posix_spawnp(&child, name.c_str(), &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) {
        fail(error);
    }
    return child;
}

int exit_status(pid_t child)
{
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return status;
}

/// The first line of gnuplot's complaint that says what is wrong: it prints the place first, with a caret.
std::string first_complaint(std::string const& text)
{
    std::istringstream lines(text);
    std::string line, said;
    while (std::getline(lines, line)) {
        if (line.find("line ") != std::string::npos) {
            return line;
        }
        if (said.empty()) {
            said = line;
        }
    }
    return said;
}

}  // namespace

bool is_installed()
{
    char const* const path = std::getenv("PATH");
    std::istringstream folders(path == nullptr ? "/usr/bin" : path);
    std::string folder;
    while (std::getline(folders, folder, ':')) {
        if (::access(((folder.empty() ? "." : folder) + "/gnuplot").c_str(), X_OK) == 0) {
            return true;
        }
    }
    return false;
}

std::string draw(std::string const& script)
{
    NamelessFile const commands = nameless(script);
    NamelessFile const complaints = nameless("");
    std::array<int, 2> ends = {};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
        fail(errno);
    }
    pid_t child = 0;
    try {
        child = start(::fileno(commands.get()), ends[1], ::fileno(complaints.get()));
    } catch (...) {
        ::close(ends[0]);
        ::close(ends[1]);
        throw;
    }
    ::close(ends[1]);
    std::string picture = drain(ends[0]);
    ::close(ends[0]);
    if (exit_status(child) != 0 || picture.empty()) {
        ::lseek(::fileno(complaints.get()), 0, SEEK_SET);
        throw std::runtime_error("gnuplot failed: " + first_complaint(drain(::fileno(complaints.get()))));
    }
    return picture;
}

}  // namespace hdconj::gnuplot
