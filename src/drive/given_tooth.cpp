// SPDX-License-Identifier: GPL-3.0-or-later
#include "given_tooth.hpp"

#include <cmath>
#include <numbers>

#include "base/text.hpp"
#include "drive.hpp"
#include "hdconj/profile/registry.hpp"
#include "hdconj/scene/parameter_fault.hpp"
#include "tooth_advice.hpp"

namespace hdconj::drive {

namespace {

/// Lengths of points that no tooth of this module has are in another unit.
void validate_height(scene::FamilyChoice const& choice, double module, profile::Profile& tooth, Faults& faults)
{
    constexpr double highest = 10;  // modules; usual teeth are 2 to 3 high
    double const height = tooth.addendum + tooth.dedendum;
    bool const file = choice.has("file");
    if (!(height > highest * module) || !(file || choice.has("points")))
        return;
    faults.push_back(scene::parameter_fault(
        choice, file ? "file" : "points",
        "the tooth would be " + short_number(height) + " mm high, " + short_number(height / module, 4) + " modules",
        file ? "name the unit in the heading, such as x [um],y [um], or write millimetres" : "write millimetres"));
    tooth = {};
}

scene::FamilyChoice const& family_of(Scene const& scene, bool outside)
{
    return outside ? *scene.circular_spline.profile : scene.flexspline.profile;
}

}  // namespace

profile::Profile build_tooth(Scene const& scene, bool outside, Faults& faults)
{
    Drive const& drive = scene.drive;
    int const difference = drive.circular_spline_teeth - drive.flexspline_teeth;
    profile::ToothPlace const place{drive.module,
                                    outside ? drive.circular_spline_teeth : drive.flexspline_teeth,
                                    outside ? 0 : scene.flexspline.wall,
                                    outside ? 0 : scene.flexspline.neutral_offset,
                                    scene.folder.string(),
                                    outside,
                                    difference,
                                    scene.wave_generator.waves};
    scene::FamilyChoice const& choice = family_of(scene, outside);
    profile::Profile tooth = profile::build_profile(choice, place, faults);
    validate_height(choice, drive.module, tooth, faults);
    return tooth;
}

profile::Profile tooth_of(Scene const& scene, bool outside, Faults& faults)
{
    std::size_t const before = faults.size();
    profile::Profile tooth = build_tooth(scene, outside, faults);
    if (faults.size() > before)
        advise_tooth(scene, outside, faults[before]);
    return tooth;
}

WidestPlace widest_place(Scene const& scene, profile::Profile const& tooth, PairGeometry const& g, bool outside)
{
    WidestPlace widest;
    double const chord = (tooth.addendum + tooth.dedendum) * 0x1p-10;
    double const half_pitch =
        std::numbers::pi / (outside ? scene.drive.circular_spline_teeth : scene.drive.flexspline_teeth);
    for (Vec2 const& p : profile::polygon_of(tooth, chord)) {
        double const radius = outside ? given_tooth_seat(g, tooth) - p.y() : g.r_m + p.y();
        double const half = std::abs(p.x());
        double const excess = outside ? std::atan2(half, radius) - half_pitch : half - half_pitch * radius;
        if (excess > widest.excess)
            widest = {excess, p, 2 * half_pitch * radius};
    }
    return widest;
}

void validate_width(Scene const& scene, profile::Profile const& tooth, PairGeometry const& g, bool outside,
                    Faults& faults)
{
    WidestPlace const widest = widest_place(scene, tooth, g, outside);
    if (!(widest.excess > 0))
        return;
    scene::FamilyChoice const& choice = family_of(scene, outside);
    faults.push_back({choice.path, choice.line, "",
                      "the tooth is wider than its pitch: " + short_number(2 * std::abs(widest.point.x())) +
                          " mm thick at height " + short_number(widest.point.y() - tooth.pitch_line) +
                          " mm, where the pitch is " + short_number(widest.pitch) + " mm",
                      "make the tooth thinner, or use fewer teeth or a larger module"});
    advise_tooth(scene, outside, faults.back());
}

}  // namespace hdconj::drive
