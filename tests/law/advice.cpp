// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Notes and their advice: what is advised works, and the size of a drive changes nothing.
#include <algorithm>
#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include "hdconj/check.hpp"
#include "hdconj/judgement.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/solve.hpp"
#include "support/catch.hpp"

namespace hdconj::test::advice_cases {
namespace {

using Keys = std::vector<std::string>;

Keys drive(std::string const& module, std::string const& flexspline, std::string const& spline, std::string const& wall)
{
    return {"drive.module=" + module, "drive.flexspline_teeth=" + flexspline, "drive.circular_spline_teeth=" + spline,
            "flexspline.wall=" + wall};
}

Keys joined(Keys keys, Keys const& more)
{
    keys.insert(keys.end(), more.begin(), more.end());
    return keys;
}

Scene scene_of(Keys const& keys)
{
    return parse_scene("", "drive", {}, keys);
}

Notes advised(Scene const& scene)
{
    Solution solution = solve(scene);
    try_advice(solution);
    return solution.judgement;
}

double beyond(Notes const& notes, NoteCode code)
{
    auto const note = std::ranges::find(notes, code, &Note::code);
    if (note == notes.end())
        return 0;
    DesignRange const& usual = design_limits()[static_cast<std::size_t>(code)].usual;
    return std::max(usual.low - note->figure, note->figure - usual.high);
}

Keys wave(std::string const& family, std::string const& waves, std::string const& deformation)
{
    return {"wave_generator.family=" + family, "wave_generator.waves=" + waves,
            "wave_generator.radial_deformation=" + deformation};
}

/// Drives with several notes, and advice that needs to be tried.
std::vector<Keys> poor_drives()
{
    std::string const p = "flexspline.profile.";
    return {joined(joined(drive("0.5", "86", "88", "0.41"), wave("cosine", "2", "0.5")),
                   {p + "family=straight", p + "addendum=0.3", p + "dedendum=0.66", p + "thickness=0.61",
                    p + "pressure_angle_deg=17.9"}),
            joined(joined(drive("0.4", "186", "188", "0.7"), wave("ellipse", "2", "0.4")),
                   {p + "family=involute", p + "addendum=0.22", p + "dedendum=0.54", p + "pressure_angle_deg=17.6"}),
            joined(joined(drive("0.3", "80", "81", "0.26"), wave("cosine", "1", "0.15")),
                   {p + "family=double-circular-arc", p + "addendum=0.228", p + "dedendum=0.364",
                    p + "convex_radius=0.357", p + "convex_offset=0.108", p + "concave_radius=0.617",
                    p + "concave_rise=0.081", p + "concave_offset=tangent", "circular_spline.inner_radius=12.126"}),
            joined(joined(drive("0.5", "192", "195", "1.0"), wave("cosine", "3", "0.51")),
                   {p + "family=s-tooth", p + "addendum=0.39", p + "dedendum=0.48", p + "deflection=0.95"}),
            joined(joined(drive("0.32", "158", "162", "0.5752"), wave("ellipse", "2", "0.47794")),
                   {p + "family=s-tooth", p + "addendum=0.23289", p + "dedendum=0.33245", p + "deflection=1.07305",
                    "circular_spline.inner_radius=25.5994", "circular_spline.backlash_offset=0.02821"}),
            joined(joined(drive("0.4", "81", "84", "0.9481"), wave("cosine", "3", "0.62579")),
                   {p + "family=double-circular-arc", p + "addendum=0.35085", p + "dedendum=0.4848",
                    p + "convex_radius=0.42855", p + "convex_offset=0.15855", p + "concave_radius=0.8232",
                    p + "concave_rise=0.10736", p + "concave_offset=tangent", "circular_spline.inner_radius=16.6582",
                    "circular_spline.backlash_offset=0.01392"})};
}

}  // namespace

TEST_CASE("law: advice with values makes a drive whose figure is nearer to its usual range", "[law][judgement]")
{
    std::size_t tried = 0;
    for (Keys const& keys : poor_drives()) {
        Notes const notes = advised(scene_of(keys));
        for (Note const& note : notes) {
            if (note.set.empty() || note.code == NoteCode::sharp_corner)
                continue;
            INFO(keys[0] << ' ' << keys[1] << ": " << to_string(note.code) << ": " << note.advice);
            Notes const after = solve(scene_of(joined(keys, note.set))).judgement;
            CHECK(beyond(after, note.code) < beyond(notes, note.code));
            ++tried;
        }
    }
    CHECK(tried >= 6);
}

TEST_CASE("law: the advice of all notes can be followed together", "[law][judgement]")
{
    for (Keys const& keys : poor_drives()) {
        Notes const notes = advised(scene_of(keys));
        Keys all = keys;
        for (Note const& note : notes)
            all = joined(all, note.set);
        Notes const after = solve(scene_of(all)).judgement;
        INFO(keys[0] << ' ' << keys[1] << ":\n" << describe(notes) << describe(after));
        CHECK(warnings_of(after) <= warnings_of(notes));
        for (Note const& note : notes)
            if (!note.set.empty())
                CHECK(beyond(after, note.code) < beyond(notes, note.code));
    }
}

TEST_CASE("law: what undercut costs changes little with a little more deformation", "[law][judgement]")
{
    double before = -1;
    for (char const* const w0 : {"0.262", "0.264", "0.266", "0.268", "0.27"}) {
        Solution const solution = solve(builtin_scene({std::string("wave_generator.radial_deformation=") + w0}));
        FlankEngagement const& contact = solution.flank_contact;
        CAPTURE(w0, contact.angle, contact.used, contact.lost, before);
        CHECK(contact.used == Approx(contact.angle));  // both flanks lose the same
        CHECK(contact.lost > 0);
        CHECK(contact.lost < 0.05 * contact.used);
        CHECK((before < 0 || std::abs(contact.lost - before) < 0.01));
        before = contact.lost;
    }
}

TEST_CASE("law: a thinner wall goes with its neutral layer and inner surface", "[law][judgement]")
{
    std::vector<std::string> const drive{
        "drive.module=0.5",
        "drive.flexspline_teeth=86",
        "drive.circular_spline_teeth=88",
        "wave_generator.family=cosine",
        "wave_generator.waves=2",
        "wave_generator.radial_deformation=0.5",
        "flexspline.profile.family=straight",
        "flexspline.profile.addendum=0.3",
        "flexspline.profile.dedendum=0.66",
        "flexspline.profile.thickness=0.61",
        "flexspline.profile.pressure_angle_deg=17.9",
    };
    using Keys = std::vector<std::string>;
    for (Keys const& key : std::vector<Keys>{{"flexspline.wall=0.6", "flexspline.neutral_offset=0.2"},
                                             {"flexspline.wall=0.6", "flexspline.neutral_offset=-0.3"},
                                             {"flexspline.wall=1", "flexspline.inner_radius=19.84"}}) {
        std::vector<std::string> keys = drive;
        keys.insert(keys.end(), key.begin(), key.end());
        Scene const scene = parse_scene("", "drive", {}, keys);
        INFO(key[1] << ": " << describe(check_scene(scene)));
        REQUIRE(check_scene(scene).empty());
        Notes const notes = judge(scene);
        auto const note = std::ranges::find(notes, NoteCode::wall_stress, &Note::code);
        REQUIRE(note != notes.end());
        INFO(note->advice);
        keys.insert(keys.end(), note->set.begin(), note->set.end());
        Scene const followed = parse_scene("", "drive", {}, keys);
        CHECK(describe(check_scene(followed)).empty());
        CHECK(
            std::ranges::none_of(judge(followed), [](Note const& each) { return each.code == NoteCode::wall_stress; }));
    }
}

TEST_CASE("law: a drive of any size is judged as the same drive", "[law][judgement]")
{
    for (double const ratio : {0.5, 0.8, 1.0, 1.2, 1.5}) {
        std::vector<std::size_t> notes;
        for (double const size : {0.2, 0.28, 0.35, 0.4, 0.45, 0.7, 1.0, 1.3}) {
            Scene scene = builtin_scene();
            double const scale = size / scene.drive.module;
            scene.drive.module = size;
            for (char const* const key : {"addendum", "dedendum", "convex_radius", "convex_offset", "concave_radius",
                                          "concave_rise", "tip_line_from"}) {
                auto& value = std::get<double>(scene.flexspline.profile.given.at(key).value);
                value *= scale;
            }
            scene.flexspline.wall *= scale;
            scene.wave_generator.shape.given.at("radial_deformation").value = ratio * size;
            scene.circular_spline.inner_radius.reset();
            Notes const judged = judge(scene);
            notes.push_back(judged.size());
            bool const warned = std::ranges::any_of(judged, [](Note const& note) {
                return note.code == NoteCode::deformation && note.severity == Severity::warning;
            });
            CHECK_FALSE(warned);
        }
        CAPTURE(ratio, notes);
        CHECK(std::ranges::count(notes, notes.front()) == static_cast<std::ptrdiff_t>(notes.size()));
    }
}

}  // namespace hdconj::test::advice_cases
