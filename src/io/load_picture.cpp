// SPDX-License-Identifier: GPL-3.0-or-later
#include <chrono>

#include "load_scripts.hpp"
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

LoadPictures load_picture_names(std::filesystem::path const& file)
{
    return {named(file, "curve"), named(file, "pressure"), named(file, "cup"), named(file, "stress"), named(file, "balls")};
}

void check_load_pictures(std::filesystem::path const& file)
{
    auto const [curve, pressure, cup, stress, balls] = load_picture_names(file);
    for (auto const& each : {curve, pressure, cup, stress, balls}) {
        check_picture(each);
    }
}

std::vector<WrittenFile> write_load_pictures(LoadStudy const& study, std::filesystem::path const& file, Measurement const* measured)
{
    check_load_pictures(file);
    auto const format = format_of(file);
    auto const names = load_picture_names(file);
    std::vector<WrittenFile> written;
    auto const write = [&](char const* kind, std::string const& script, std::filesystem::path const& to) {
        auto const begin = std::chrono::steady_clock::now();
        draw_picture(script, to);
        written.push_back({kind, to, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count()});
    };
    if (has_curve(study) || measured != nullptr) {
        write("picture_curve", load_curve_script(study, measured, format), names.curve);
    }
    if (auto const* shown = shown_case(study); shown != nullptr && !shown->map.angle.empty()) {
        write("picture_pressure", load_pressure_script(study, format), names.pressure);
    }
    if (!study.shape.cells.empty()) {
        write("picture_cup", load_cup_script(study, format), names.cup);
        if (!study.shape.stress.empty()) {
            write("picture_stress", load_stress_script(study, format), names.stress);
        }
    }
    if (has_balls(study)) {
        write("picture_balls", load_ball_script(study, format), names.balls);
    }
    return written;
}

}  // namespace hdconj
