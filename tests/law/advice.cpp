// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Notes and their advice: what is advised works, and the size of a drive changes nothing.
#include <algorithm>
#include <string>
#include <variant>
#include <vector>

#include "hdconj/check.hpp"
#include "hdconj/judgement.hpp"
#include "hdconj/read_scene.hpp"
#include "support/catch.hpp"

namespace hdconj::test::advice_cases {

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
