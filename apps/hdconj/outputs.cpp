// SPDX-License-Identifier: GPL-3.0-or-later
#include "outputs.hpp"

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <iostream>

#include "cli.hpp"
#include "hdconj/io/atomic_file.hpp"
#include "hdconj/profile/registry.hpp"
#include "hdconj/scene/fault.hpp"
#include "hdconj/scene/number_pairs.hpp"
#include "hdconj/wavegen/registry.hpp"

namespace hdconj::cli {

namespace fs = std::filesystem;

namespace {

constexpr char const* erase_line = "\r\033[K";

[[noreturn]] void refuse(OutputJob const& job, std::string const& reason, std::string const& remedy)
{
    throw InputError(Fault{job.option, 0, job.file.string(), reason, "write " + remedy});
}

/// The file that a name stands for, through links, whether it exists or not.
fs::path real(fs::path const& name)
{
    std::error_code error;
    return fs::weakly_canonical(fs::absolute(name), error);
}

bool same_file(fs::path const& a, fs::path const& b)
{
    std::error_code error;
    return fs::equivalent(a, b, error) || real(a) == real(b);
}

/// @p file lies in @p folder itself: one with folders in it is no result, which is said elsewhere.
bool holds(fs::path const& folder, fs::path const& file)
{
    return same_file(real(file).parent_path(), folder);
}

void refuse_to_replace(OutputJob const& job, InputFile const& input)
{
    constexpr char const* loss = ", the result would replace it";
    if (same_file(job.file, input.file)) {
        refuse(job, input.what + loss, "another name");
    }
    for (auto const& member : job.members) {
        if (same_file(member, input.file)) {
            refuse(job, "writes " + member.string() + " too: " + input.what + loss, "another name");
        }
    }
    if (job.is_folder && holds(job.file, input.file)) {
        refuse(job, "holds " + input.file.string() + ": " + input.what + loss, "the name of a new folder");
    }
}

void refuse_to_share(OutputJob const& job, OutputJob const& other)
{
    if (same_file(other.file, job.file)) {
        refuse(job, "is given to " + other.option + " too", "another name");
    }
    for (auto const& member : other.members) {
        if (same_file(member, job.file)) {
            refuse(job, "is written by " + other.option + " too", "another name");
        }
    }
}

/// Files that the keys of one family name.
void append_files(FamilyChoice const& choice, std::vector<FamilyDescription> const& families, fs::path const& folder, std::vector<InputFile>& files)
{
    for (auto const& family : families) {
        if (family.name != choice.family) {
            continue;
        }
        for (auto const& parameter : family.parameters) {
            if (parameter.quantity == Quantity::file && choice.has(parameter.key)) {
                files.push_back({number_file(choice, parameter.key, folder), "this file is read by " + choice.path + "." + std::string(parameter.key)});
            }
        }
    }
}

}  // namespace

std::string file_name(std::string const& drive)
{
    constexpr std::size_t longest = 100;  // bytes, well below what file systems take
    constexpr unsigned char beyond_ascii = 0x80, continues = 0x80, mask = 0xC0;
    std::string name;
    for (char const c : drive.substr(0, longest)) {
        auto const byte = static_cast<unsigned char>(c);
        bool const kept = byte >= beyond_ascii || std::isalnum(byte) != 0 || c == '.' || c == '_' || c == '-';
        name += kept ? c : '-';
    }
    if (drive.size() > longest) {
        std::size_t cut = longest;
        while (cut > 0 && (static_cast<unsigned char>(drive[cut]) & mask) == continues) {
            --cut;
        }
        name.resize(cut);
    }
    name.erase(0, name.find_first_not_of(".-"));  // no hidden file, nothing that looks like an option
    return name.empty() ? "drive" : name;
}

std::vector<InputFile> inputs_of(CommonOptions const& common, Scene const& scene)
{
    std::vector<InputFile> files;
    if (!common.scene.empty() && common.scene != "-") {
        files.push_back({common.scene, "this is the scene file"});
    }
    append_files(scene.given_profile(), profile_families(), scene.folder, files);
    append_files(scene.wave_generator.shape, wave_generator_families(), scene.folder, files);
    return files;
}

std::vector<InputFile> input_of(std::string const& option, std::string const& file)
{
    return file.empty() ? std::vector<InputFile>{} : std::vector<InputFile>{{file, "this file is read by " + option}};
}

void check_outputs(std::vector<OutputJob> const& jobs, std::vector<InputFile> const& read)
{
    for (auto const& job : jobs) {
        if (job.file == "-") {
            refuse(job, "results are files and do not go to standard output",
                   "a file name; --json prints the figures to standard output");
        }
        for (auto const& input : read) {
            refuse_to_replace(job, input);
        }
        for (auto const& other : jobs) {
            if (&other != &job) {
                refuse_to_share(job, other);
            }
        }
    }
    for (auto const& job : jobs) {
        job.check();
    }
}

WrittenFile timed(std::string const& kind, fs::path const& file, std::function<void()> const& write)
{
    auto const begin = std::chrono::steady_clock::now();
    write();
    std::chrono::duration<double> const taken = std::chrono::steady_clock::now() - begin;
    return {kind, file, taken.count()};
}

int status_of_cases(std::vector<std::string> const& missing, std::size_t written)
{
    if (missing.empty()) {
        return exit_done;
    }
    std::cerr << "hdconj: " << missing.size() << " of " << missing.size() + written << " cases could not be computed; the others are written\n";
    for (auto const& each : missing) {
        std::cerr << "  " << each << '\n';
    }
    return exit_failed;
}

Progress::Progress(bool wanted) : shown_(wanted && ::isatty(STDERR_FILENO) == 1) {}

void Progress::say(std::string const& what) const
{
    if (shown_) {
        std::cerr << erase_line << what << " ..." << std::flush;
    }
}

void Progress::say(std::string const& what, double share) const
{
    constexpr int width = 30;
    int const done = std::clamp(static_cast<int>(share * width), 0, width);
    say("[" + std::string(static_cast<std::size_t>(done), '#') + std::string(static_cast<std::size_t>(width - done), '.') + "] " + what);
}

void Progress::keep(std::string const& line) const
{
    if (shown_) {
        std::cerr << erase_line << line << '\n' << std::flush;
    }
}

void Progress::clear() const
{
    if (shown_) {
        std::cerr << erase_line << std::flush;
    }
}

}  // namespace hdconj::cli
