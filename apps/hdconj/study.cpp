// SPDX-License-Identifier: GPL-3.0-or-later
// hdconj study: hands over to the program hdconj-study of the Python package.
#include "study.hpp"

#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <system_error>

#include "verb.hpp"

namespace hdconj::cli {

int start_study_program(std::vector<std::string> words)
{
    std::string const name = "hdconj-study";
    words.front() = name;
    std::vector<char*> arguments;
    for (auto& word : words)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);
    std::signal(SIGPIPE, SIG_DFL);
    std::signal(SIGXFSZ, SIG_DFL);
    std::error_code none;
    auto const own = std::filesystem::read_symlink("/proc/self/exe", none);
    if (!none)
        execv((own.parent_path() / name).c_str(), arguments.data());
    execvp(name.c_str(), arguments.data());
    std::cerr << "hdconj: the verb study needs the program " << name << ", "
              << (errno == ENOENT ? "which is neither beside hdconj nor on the path"
                                  : "which cannot be run: " + std::generic_category().message(errno))
              << "; install it with: pip install 'hdconj[study]'\n";
    return exit_failed;
}

}  // namespace hdconj::cli
