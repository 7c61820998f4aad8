// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Drives that cannot be made: what is named as the remedy makes them.
#include <algorithm>
#include <string>
#include <vector>

#include "hdconj/contact.hpp"
#include "hdconj/error.hpp"
#include "hdconj/judgement.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/solve.hpp"
#include "support/catch.hpp"

namespace hdconj::test::remedies_cases {
namespace {

using Keys = std::vector<std::string>;

Scene scene_of(Keys const& keys)
{
    return parse_scene("", "drive", {}, keys);
}

Scene scene_of(Keys keys, Keys const& more)
{
    keys.insert(keys.end(), more.begin(), more.end());
    return scene_of(keys);
}

/// What ends the work of @p verb on the drive of @p keys.
template <class Verb>
NumericalError failure(Verb const& verb, Keys const& keys)
{
    try {
        (void)verb(scene_of(keys));
    } catch (NumericalError const& error) {
        return error;
    }
    throw std::logic_error("it was made");
}

auto const solved = [](Scene const& scene) { return solve(scene); };

/// One wave, whose circular spline has involute teeth that are given.
Keys one_wave(std::string const& deformation, std::string const& given_addendum = "0.6")
{
    std::string const given = "circular_spline.profile.";
    return {"drive.module=1",
            "drive.flexspline_teeth=80",
            "drive.circular_spline_teeth=81",
            "flexspline.wall=1",
            "flexspline.addendum=0.7",
            "flexspline.dedendum=1",
            "wave_generator.family=cosine",
            "wave_generator.waves=1",
            given + "family=involute",
            given + "addendum=" + given_addendum,
            given + "dedendum=0.9",
            given + "pressure_angle_deg=20",
            "wave_generator.radial_deformation=" + deformation};
}

/// Straight teeth that touch with their tips alone.
Keys steep_teeth(std::string const& width)
{
    std::string const tooth = "flexspline.profile.";
    return {"drive.module=0.5",
            "drive.flexspline_teeth=320",
            "drive.circular_spline_teeth=322",
            "flexspline.wall=1",
            tooth + "family=straight",
            tooth + "addendum=0.35",
            tooth + "dedendum=0.45",
            tooth + "thickness=0.75",
            tooth + "pressure_angle_deg=8",
            "wave_generator.family=cosine",
            "wave_generator.waves=2",
            "wave_generator.radial_deformation=0.5",
            "circular_spline.width=" + width};
}

}  // namespace

TEST_CASE("tips of a given circular spline that never part are the cause, and the addendum the remedy", "[judgement]")
{
    for (std::string const deformation : {"0.4", "0.52", "0.6", "0.65"}) {
        Keys const keys = one_wave(deformation);
        NumericalError const failed = failure(solved, keys);
        INFO(failed.what());
        bool const is_usual = deformation == "0.52" || deformation == "0.6";
        if (is_usual)
            CHECK_THAT(failed.cause(), ContainsSubstring("likely because the tips never leave the tip circle"));
        if (deformation != "0.4")  // a usual deformation makes more of the tips overlap
            CHECK_THAT(failed.what(), !ContainsSubstring("radial_deformation ="));
        REQUIRE_FALSE(failed.set().empty());
        CHECK_THAT(failed.remedy(), ContainsSubstring("flexspline.addendum = "));
        CHECK_NOTHROW(solve(scene_of(keys, failed.set())));
    }
}

TEST_CASE("the usual deformation of a given circular spline comes with an addendum that leaves it", "[judgement]")
{
    for (std::string const deformation : {"0.69", "0.75"}) {
        Keys const keys = one_wave(deformation);
        Notes const notes = solve(scene_of(keys)).judgement;
        auto const note = std::ranges::find(notes, NoteCode::deformation, &Note::code);
        REQUIRE(note != notes.end());
        INFO(note->advice);
        Notes const after = solve(scene_of(keys, note->set)).judgement;
        CHECK(std::ranges::find(after, NoteCode::deformation, &Note::code) == after.end());
        CHECK(std::ranges::find(after, NoteCode::late_mesh, &Note::code) == after.end());
    }
}

TEST_CASE("late mesh with a given circular spline names an addendum that ends it", "[judgement]")
{
    for (std::string const given : {"0.4", "0.6", "0.85"}) {
        Keys const keys = one_wave("0.52", given);
        Notes const notes = judge(scene_of(keys));
        auto const note = std::ranges::find(notes, NoteCode::late_mesh, &Note::code);
        REQUIRE(note != notes.end());
        INFO(given << ": " << note->advice);
        Notes const after = judge(scene_of(keys, note->set));
        CHECK(std::ranges::find(after, NoteCode::late_mesh, &Note::code) == after.end());
    }
}

TEST_CASE("a surface without a flank names what lets one touch, and no width where the plane has none", "[judgement]")
{
    auto const in_contact = [](Scene const& scene) { return study_contact(scene); };
    Keys const flat = steep_teeth("5");
    NumericalError const failed = failure(in_contact, flat);
    INFO(failed.what());
    CHECK(failed.code() == ErrorCode::no_flank);
    for (char const* const useless : {"width", "radial_deformation", "larger flexspline.profile.addendum"})
        CHECK_THAT(failed.remedy(), !ContainsSubstring(useless));
    REQUIRE_FALSE(failed.set().empty());
    CHECK(study_contact(scene_of(flat, failed.set())).cases.front().state.teeth > 2);
    // slices with less deformation than the plane z = 0
    Keys ruled = steep_teeth("4");
    for (char const* const key : {"coning.model=linear", "coning.bottom_to_middle=20", "slices.count=2",
                                  "slices.surface=ruled", "wave_generator.radial_deformation=0.45"})
        ruled.emplace_back(key);
    NumericalError const sliced = failure(solved, ruled);
    INFO(sliced.what());
    CHECK_THAT(sliced.remedy(), !ContainsSubstring("width"));
    CHECK_NOTHROW(solve(scene_of(ruled, sliced.set())));
}

TEST_CASE("a land that is lost far inside the usual tip circle is won by a tip circle", "[judgement]")
{
    std::string const tooth = "flexspline.profile.";
    Keys const keys{"drive.module=1",
                    "drive.flexspline_teeth=600",
                    "drive.circular_spline_teeth=601",
                    "flexspline.wall=6",
                    tooth + "family=cycloid",
                    tooth + "addendum=0.92",
                    tooth + "dedendum=0.95",
                    tooth + "addendum_rolling_radius=1.1",
                    tooth + "dedendum_rolling_radius=2",
                    "wave_generator.family=cosine",
                    "wave_generator.waves=1",
                    "wave_generator.radial_deformation=0.42"};
    NumericalError const failed = failure(solved, keys);
    INFO(failed.what());
    REQUIRE(failed.code() == ErrorCode::no_land);
    REQUIRE(failed.set().size() == 1);
    CHECK(failed.set().front().starts_with("circular_spline.inner_radius="));
    Notes const after = solve(scene_of(keys, failed.set())).judgement;
    CHECK(std::ranges::find(after, NoteCode::late_mesh, &Note::code) == after.end());
}

}  // namespace hdconj::test::remedies_cases
