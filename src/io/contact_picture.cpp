// SPDX-License-Identifier: GPL-3.0-or-later
#include <chrono>

#include "contact_scripts.hpp"
#include "hdconj/io/contact_files.hpp"
#include "picture_file.hpp"

namespace hdconj {
namespace {

/// NAME.svg becomes NAME-what.svg.
std::filesystem::path named(std::filesystem::path const& file, char const* what)
{
    auto name = file.stem();
    name += std::string("-") + what;
    name += file.extension();
    return file.parent_path() / name;
}

}  // namespace

ContactPictures contact_picture_names(std::filesystem::path const& file)
{
    return {named(file, "tilt"), named(file, "map"), named(file, "flank")};
}

void check_contact_pictures(std::filesystem::path const& file)
{
    auto const [tilt, map, flank] = contact_picture_names(file);
    for (auto const& each : {tilt, map, flank}) {
        check_picture(each);
    }
}

std::vector<WrittenFile> write_contact_pictures(ContactStudy const& study, std::filesystem::path const& file)
{
    check_contact_pictures(file);
    auto const format = format_of(file);
    auto const [tilt, map, flank] = contact_picture_names(file);
    std::vector<WrittenFile> written;
    auto const write = [&](char const* kind, auto const& script_of, std::filesystem::path const& to) {
        auto const begin = std::chrono::steady_clock::now();
        draw_picture(script_of(study, format), to);
        written.push_back({kind, to, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count()});
    };
    if (has_tilt_curve(study)) {
        write("picture_tilt", tilt_script, tilt);
    }
    if (!study.map.gap.empty()) {
        write("picture_map", map_script, map);
        write("picture_flank", flank_script, flank);
    }
    return written;
}

}  // namespace hdconj
