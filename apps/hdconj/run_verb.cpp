// SPDX-License-Identifier: GPL-3.0-or-later
#include "run_verb.hpp"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <iostream>

namespace hdconj::cli {
namespace {

constexpr char const* erase_line = "\r\033[K";

}  // namespace

ProgressLine::ProgressLine(bool wanted) : shown_(wanted && ::isatty(STDERR_FILENO) == 1) {}

void ProgressLine::say(std::string const& what) const
{
    if (shown_)
        std::cerr << erase_line << what << " ..." << std::flush;
}

void ProgressLine::say(std::string const& what, double share) const
{
    constexpr int width = 30;
    int const done = std::clamp(static_cast<int>(share * width), 0, width);
    say("[" + std::string(static_cast<std::size_t>(done), '#') +
        std::string(static_cast<std::size_t>(width - done), '.') + "] " + what);
}

void ProgressLine::keep(std::string const& line) const
{
    if (shown_)
        std::cerr << erase_line << line << '\n' << std::flush;
}

void ProgressLine::clear() const
{
    if (shown_)
        std::cerr << erase_line << std::flush;
}

StageObserver ProgressLine::stages() const
{
    return [this](Stage stage) { say(to_string(stage)); };
}

std::function<void(std::string const&, double)> ProgressLine::shares() const
{
    return [this](std::string const& what, double share) { say(what, share); };
}

WrittenFile timed(std::string const& kind, std::filesystem::path const& file, std::function<void()> const& write)
{
    auto const begin = std::chrono::steady_clock::now();
    write();
    std::chrono::duration<double> const taken = std::chrono::steady_clock::now() - begin;
    return {kind, file, taken.count()};
}

std::vector<std::string> names_of(Written const& written)
{
    std::vector<std::string> names;
    for (auto const& each : written)
        names.push_back(each.file.string());
    return names;
}

int status_of_missing(std::vector<std::string> const& missing)
{
    if (missing.empty())
        return exit_done;
    std::cerr << "hdconj: " << missing.size() << (missing.size() == 1 ? " result is" : " results are")
              << " missing; what could be computed is written\n";
    for (auto const& each : missing)
        std::cerr << "  " << each << '\n';
    return exit_failed;
}

int strict_status(CommonOptions const& common, Notes const& notes, int status)
{
    std::size_t const warnings = warnings_of(notes);
    if (status != exit_done || !common.strict || warnings == 0)
        return status;
    std::cerr << "hdconj: the judgement of the design holds " << warnings << (warnings == 1 ? " warning" : " warnings")
              << ", and --strict is given\n";
    return exit_failed;
}

void print_result(CommonOptions const& common, std::string const& text, std::vector<std::string> const& wrote)
{
    std::cout << text;
    if (common.quiet)
        return;
    for (auto const& each : wrote)
        std::cerr << "wrote " << each << '\n';
}

}  // namespace hdconj::cli
