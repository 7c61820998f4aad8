// SPDX-License-Identifier: GPL-3.0-or-later
#include "flank_ways.hpp"

#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "scene/usual_drive.hpp"

namespace hdconj::judgement {
namespace {

using Ways = std::vector<std::vector<std::string>>;

/// @p values but @p now, the nearest to it first.
std::vector<double> others(std::vector<double> values, double now)
{
    constexpr double near = 0.02;  // of the value: as good as that
    std::erase_if(values, [&](double each) { return std::abs(each - now) <= near * now; });
    std::ranges::sort(values, {}, [&](double each) { return std::abs(each - now); });
    return values;
}

void add_angles(Ways& ways, Scene const& scene)
{
    scene::FamilyChoice const& tooth = scene.given_profile();
    auto const angle = tooth.number("pressure_angle_deg");
    if (!angle || (tooth.family != "straight" && tooth.family != "involute"))
        return;
    for (double const each : others({16, 18, 20, 22, 24, 26, 28, 30, 32}, *angle))
        ways.push_back({tooth.path + ".pressure_angle_deg=" + short_number(each)});
}

void add_addenda(Ways& ways, Scene const& scene, double w0)
{
    auto const addendum = scene.is_reverse() ? std::nullopt : scene.flexspline.profile.number("addendum");
    if (!addendum)
        return;
    for (double const each : others({0.6, 0.7, 0.8, 0.9, 1.0}, *addendum / scene.drive.module))
        ways.push_back(scene::with_addendum(scene, w0, each * scene.drive.module).set);
}

void add_deformations(Ways& ways, Scene const& scene, double w0)
{
    double const usual = scene::usual_deformation(scene.drive);
    for (double const each : others({0.8, 0.85, 0.9, 0.95, 1.0, 1.05, 1.1, 1.15, 1.2}, w0 / usual))
        if (auto way = scene::with_deformation(scene, each * usual).set; !way.empty())
            ways.push_back(std::move(way));
}

}  // namespace

Ways flank_ways(NoteCode code, Solution const& solution)
{
    Scene const& scene = solution.scene;
    double const w0 = solution.geometry.w0;
    Ways ways{{}};
    if (auto usual = scene::usual_pair(scene, w0).set; !usual.empty())
        ways.push_back(std::move(usual));
    if (code == NoteCode::flank_contact) {
        add_angles(ways, scene);
        add_addenda(ways, scene, w0);
    }
    add_deformations(ways, scene, w0);
    return ways;
}

}  // namespace hdconj::judgement
