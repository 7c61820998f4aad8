// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Runs another program, or a piece of the test in a process of its own.
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "temporary_folder.hpp"

namespace hdconj::test {

struct Outcome
{
    int status = -1;  ///< exit status; 128 and the signal's number when a signal ended it
    std::string out;  ///< standard output
    std::string err;  ///< standard error
};

inline int status_of_wait(int waited)
{
    constexpr int by_signal = 128;
    return WIFEXITED(waited) ? WEXITSTATUS(waited) : by_signal + WTERMSIG(waited);
}

/// Runs a shell command in @p folder.
inline Outcome run(std::string const& command, std::filesystem::path const& folder = ".")
{
    TemporaryFolder const files;
    std::string const out = (files / "out").string(), err = (files / "err").string();
    std::string const line = "cd '" + folder.string() + "' && ( " + command + " ) >'" + out + "' 2>'" + err + "'";
    int const status = status_of_wait(std::system(line.c_str()));
    return {status, content(out), content(err)};
}

/// Whether a program that a test would call is not there.
inline bool is_missing(std::string const& name)
{
    return run("command -v " + name).status != 0;
}

/// Runs @p action in a child process; its result is the exit status.
template <class Action>
int in_child(Action action)
{
    pid_t const child = ::fork();
    if (child == 0)
        ::_exit(action());
    int waited = 0;
    ::waitpid(child, &waited, 0);
    return status_of_wait(waited);
}

}  // namespace hdconj::test
