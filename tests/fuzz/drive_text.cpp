// SPDX-License-Identifier: GPL-3.0-or-later
#include "drive_text.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "hdconj/read_scene.hpp"
#include "scratch_folder.hpp"

namespace hdconj::fuzz {
namespace {

/// More are no drive, and cost time only.
constexpr std::size_t most_overrides = 64;

std::map<std::string, std::string> const& scenes()
{
    static std::map<std::string, std::string> const texts = [] {
        std::map<std::string, std::string> found;
        for (auto const& entry : std::filesystem::directory_iterator(HDCONJ_SOURCE_DIR "/data/scenes")) {
            if (entry.path().extension() == ".toml")
                found[entry.path().stem().string()] = test::content(entry.path());
        }
        return found;
    }();
    return texts;
}

/// The first word of @p text and what follows it.
std::pair<std::string_view, std::string_view> split(std::string_view text)
{
    std::size_t const blank = text.find(' ');
    return {text.substr(0, blank), blank == std::string_view::npos ? std::string_view{} : text.substr(blank + 1)};
}

}  // namespace

DriveText parse_drive(std::string_view text)
{
    DriveText drive;
    while (!text.empty()) {
        std::size_t const end = text.find('\n');
        std::string_view const line = text.substr(0, end);
        text = end == std::string_view::npos ? std::string_view{} : text.substr(end + 1);
        auto const [word, rest] = split(line);
        if (line.empty() || line.front() == '#')
            continue;
        if (word == "scene")
            drive.scene = rest;
        else if (word == "points")
            drive.files[std::string(split(rest).first)] = split(rest).second;
        else if (drive.overrides.size() < most_overrides)
            drive.overrides.emplace_back(line);
    }
    return drive;
}

std::string to_text(DriveText const& drive)
{
    std::string text;
    if (!drive.scene.empty())
        text += "scene " + drive.scene + "\n";
    for (auto const& [name, pairs] : drive.files)
        text += "points " + name + " " + pairs + "\n";
    for (std::string const& line : drive.overrides)
        text += line + "\n";
    return text;
}

std::vector<std::string> const& scene_names()
{
    static std::vector<std::string> const names = [] {
        std::vector<std::string> all;
        for (auto const& [name, text] : scenes())
            all.push_back(name);
        return all;
    }();
    return names;
}

std::string const& base_text(DriveText const& drive)
{
    static std::string const builtin(builtin_scene_text());
    auto const found = scenes().find(drive.scene);
    return found == scenes().end() ? builtin : found->second;
}

Scene scene_of(DriveText const& drive)
{
    for (auto const& [name, pairs] : drive.files) {
        std::string lines = pairs;
        std::replace(lines.begin(), lines.end(), ' ', '\n');
        bool const plain = !name.empty() && name.find('/') == std::string::npos && name.find('\0') == std::string::npos;
        if (plain && name != "." && name != "..")
            write_scratch(name, lines);
    }
    return parse_scene(base_text(drive), "fuzzed drive", scratch_folder(), drive.overrides);
}

}  // namespace hdconj::fuzz
