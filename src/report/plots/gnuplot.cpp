// SPDX-License-Identifier: GPL-3.0-or-later
#include "gnuplot.hpp"

#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <sstream>
#include <system_error>

#include <fmt/format.h>

namespace hdconj::report::gnuplot {
namespace {

using NamelessFile = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

[[noreturn]] void fail()
{
    throw GnuplotError("cannot run gnuplot: " + std::generic_category().message(errno));
}

/// A temporary file without a name: gone with the process, whatever becomes of it.
NamelessFile nameless(std::string const& content)
{
    NamelessFile file(std::tmpfile(), &std::fclose);
    if (!file || std::fwrite(content.data(), 1, content.size(), file.get()) != content.size() ||
        std::fflush(file.get()) != 0)
        fail();
    std::rewind(file.get());
    return file;
}

std::string read_all(std::FILE* file)
{
    std::string all;
    std::array<char, std::size_t{1} << 16> block;
    while (std::size_t const count = std::fread(block.data(), 1, block.size(), file))
        all.append(block.data(), count);
    return all;
}

/// The first line of gnuplot's complaint that says what is wrong, or else its first warning: version 6 only warns of an
/// unknown terminal. Gnuplot prints the place first, with a caret.
std::string first_complaint(std::string const& text)
{
    std::istringstream lines(text);
    std::string line, said;
    while (std::getline(lines, line)) {
        bool const says_what = line.find("line ") != std::string::npos;
        if (says_what && line.find("warning: ") == std::string::npos)
            return line;
        if (said.empty() || (says_what && said.find("line ") == std::string::npos))
            said = line;
    }
    return said;
}

}  // namespace

bool is_installed()
{
    char const* const path = std::getenv("PATH");
    std::istringstream folders(path == nullptr ? "/usr/bin" : path);
    std::string folder;
    while (std::getline(folders, folder, ':'))
        if (::access(((folder.empty() ? "." : folder) + "/gnuplot").c_str(), X_OK) == 0)
            return true;
    return false;
}

std::string draw(std::string const& script)
{
    if (!is_installed())
        throw GnuplotError(missing);
    NamelessFile const commands = nameless(script), complaints = nameless("");
    // Without the user's settings, so that pictures look the same everywhere.
    std::string const command = fmt::format("exec gnuplot --default-settings - </dev/fd/{} 2>/dev/fd/{}",
                                            ::fileno(commands.get()), ::fileno(complaints.get()));
    std::FILE* const process = ::popen(command.c_str(), "r");
    if (process == nullptr)
        fail();
    std::string picture = read_all(process);
    if (::pclose(process) != 0 || picture.empty())
        throw GnuplotError("gnuplot failed: " + first_complaint(read_all(complaints.get())));
    return picture;
}

}  // namespace hdconj::report::gnuplot
