// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Hard cases of whole drives. Rows that once broke something say so.
#include <cstdio>
#include <fstream>

#include "hdconj/motion/exact_motion.hpp"
#include "hdconj/wavegen/cosine_cam.hpp"
#include "row.hpp"
#include "support/temporary_folder.hpp"

namespace hdconj::test::designs_cases {

namespace {

std::string digits17(double value)
{
    char text[40];
    std::snprintf(text, sizeof text, "%.17g", value);
    return text;
}

Overrides const own_tip_circle{"!circular_spline.inner_radius"};

Overrides const fast_contact{"drive.module=0.37667952570639884",
                             "drive.flexspline_teeth=283",
                             "drive.circular_spline_teeth=284",
                             "flexspline.wall=0.7102075460577444",
                             "!flexspline.profile",
                             "flexspline.profile.family=straight",
                             "flexspline.profile.addendum=0.1956688069507966",
                             "flexspline.profile.dedendum=0.2512165357218547",
                             "flexspline.profile.pressure_angle_deg=23.501926364864964",
                             "flexspline.profile.thickness=0.4412388595728802",
                             "wave_generator.radial_deformation=0.20596721136485",
                             "wave_generator.waves=1",
                             "circular_spline.inner_radius=53.32369505785473"};

Overrides straight(std::string const& addendum, std::string const& angle, std::string const& thickness)
{
    return {"!flexspline.profile",
            "flexspline.profile.family=straight",
            "flexspline.profile.addendum=" + addendum,
            "flexspline.profile.dedendum=0.303",
            "flexspline.profile.pressure_angle_deg=" + angle,
            "flexspline.profile.thickness=" + thickness,
            "!circular_spline.inner_radius"};
}

/// An offset of 20 um closes over its corner path of 3.4 um.
Overrides const short_corner_path{"flexspline.profile.addendum=0.1763",
                                  "flexspline.profile.tip_line_from=0.0624",
                                  "flexspline.profile.convex_offset=0.0252",
                                  "flexspline.profile.convex_radius=0.3007",
                                  "flexspline.profile.concave_radius=0.6552",
                                  "flexspline.profile.concave_rise=-0.0462",
                                  "wave_generator.radial_deformation=0.3002",
                                  "!circular_spline.inner_radius",
                                  "solver.kinematics=first-order"};

Overrides const swallowtail{"drive.module=0.285372766780939",
                            "drive.flexspline_teeth=207",
                            "drive.circular_spline_teeth=210",
                            "flexspline.wall=0.49858889072490536",
                            "flexspline.profile.addendum=0.18224747639293287",
                            "flexspline.profile.concave_radius=0.4261321264493276",
                            "flexspline.profile.concave_rise=0.08679811073874014",
                            "flexspline.profile.convex_offset=0.20624919686977042",
                            "flexspline.profile.convex_radius=0.3942594164048105",
                            "flexspline.profile.convex_rise=-0.07210057745713667",
                            "flexspline.profile.dedendum=0.19135985021257954",
                            "flexspline.profile.tip_line_from=0.10595148905275835",
                            "wave_generator.radial_deformation=0.4280591501714085",
                            "wave_generator.waves=3",
                            "!circular_spline.inner_radius"};

/// Type-50's drive with a tooth whose convex arc is centred where the tooth's instantaneous centre passes at @p
/// degrees, @p away from it.
Overrides centre_at_rest(double degrees, double away)
{
    motion::ExactMotion<wavegen::CosineCam> const motion(
        wavegen::NeutralCurve<wavegen::CosineCam>(wavegen::CosineCam{0.25, 2}, 24.347), 200.0 / 202);
    PlanarVelocity const twist = motion.rates(degrees * 3.14159265358979324 / 180).twist;
    double const x = twist.q.y() / twist.omega;
    double const rise = -twist.q.x() / twist.omega - 0.653 + away;
    return {"flexspline.profile.convex_radius=" + digits17(std::hypot(0.17 - x, rise)),
            "flexspline.profile.convex_offset=" + digits17(-x),
            "flexspline.profile.convex_rise=" + digits17(rise),
            "flexspline.profile.concave_rise=0.1",
            "flexspline.profile.concave_radius=0.5",
            "!flexspline.profile.tip_line_from",
            "!circular_spline.inner_radius"};
}

/// Every length of type-50, times a factor, in 17 digits.
Overrides scaled(double factor)
{
    Overrides result;
    for (auto const& [key, value] : {std::pair{"drive.module", 0.25},
                                     {"flexspline.wall", 0.7},
                                     {"flexspline.profile.addendum", 0.2250},
                                     {"flexspline.profile.dedendum", 0.3030},
                                     {"flexspline.profile.convex_radius", 0.2701},
                                     {"flexspline.profile.convex_offset", 0.0982},
                                     {"flexspline.profile.concave_radius", 0.5145},
                                     {"flexspline.profile.concave_rise", 0.0671},
                                     {"flexspline.profile.tip_line_from", 0.19},
                                     {"wave_generator.radial_deformation", 0.25},
                                     {"circular_spline.inner_radius", 25.025},
                                     {"circular_spline.width", 7.0},
                                     {"solver.tolerance", 1e-6}})
        result.push_back(std::string(key) + "=" + digits17(value * factor));
    return result;
}

/// Largest distance between outlines at the same place, @p b in its own unit; of the landmarks where the numbers of
/// points differ.
double difference(Solution const& a, Solution const& b, double factor = 1)
{
    auto const& p = a.circular_spline.outline[0];
    auto const& q = b.circular_spline.outline[0];
    double worst = 0;
    if (p.size() == q.size()) {
        for (std::size_t i = 0; i < p.size(); ++i)
            worst = std::max(worst, (p[i] - q[i] / factor).norm());
        return worst;
    }
    for (std::size_t k = 0; k < a.circular_spline.landmarks.size(); ++k) {
        Vec2 const at_a = p[static_cast<std::size_t>(a.circular_spline.landmarks[k])];
        Vec2 const at_b = q[static_cast<std::size_t>(b.circular_spline.landmarks[k])];
        worst = std::max(worst, (at_a - at_b / factor).norm());
    }
    return worst;
}

Overrides points_file(TemporaryFolder const& folder, std::string const& content)
{
    std::ofstream(folder / "points.csv") << content;
    return {"!flexspline.profile", "flexspline.profile.family=points",
            "flexspline.profile.file=" + (folder / "points.csv").string(), "!circular_spline.inner_radius"};
}

Overrides table_cam(TemporaryFolder const& folder, std::string const& content)
{
    std::ofstream(folder / "cam.csv") << content;
    return {"wave_generator.family=table", "!wave_generator.radial_deformation",
            "wave_generator.file=" + (folder / "cam.csv").string()};
}

}  // namespace

// the motion

HARD_ROW("one wave", "q_x is the difference of two lengths of 24 mm and all but vanishes", "right answer")
{
    right_answer({"wave_generator.waves=1", "circular_spline.inner_radius=25.12"});
}

HARD_ROW("two waves", "the usual drive", "right answer")
{
    right_answer(Overrides{});
}

HARD_ROW("three waves", "teeth differ by 3", "right answer")
{
    right_answer({"drive.circular_spline_teeth=203", "wave_generator.waves=3"});
}

HARD_ROW("first order", "the other motion model", "right answer")
{
    right_answer({"solver.kinematics=first-order"});
}

HARD_ROW("material", "the third motion model", "right answer")
{
    right_answer({"solver.kinematics=material"});
}

HARD_ROW("turn of the tooth reverses", "theta' = 0 at 57 degrees: contacts of lines run to infinity there",
         "right answer")
{
    right_answer(straight("0.225", "20", "0.36"));
}

HARD_ROW("centre at rest", "V_C = 0 to the last bit: a whole arc touches at one instant", "right answer")
{
    right_answer(centre_at_rest(2, 0));
}

HARD_ROW("centre at rest later", "the same at 4 degrees", "right answer")
{
    right_answer(centre_at_rest(4, 0));
}

HARD_ROW("centre nearly at rest",
         "V_C = 4e-17 to 4e-13: the contact runs along the arc within some roundings of the angle", "right answer")
{
    for (double away : {1e-15, -1e-15, 1e-13, 1e-11})
        right_answer(centre_at_rest(2, away));
}

HARD_ROW("centre passes its rest slowly", "V_C = 4e-8: a branch 5e-8 rad long", "right answer")
{
    right_answer(centre_at_rest(2, 1e-6));
}

HARD_ROW("centre at rest against its neighbours", "distance of the centre to 0", "outlines tend to the one at rest")
{
    Solution const at = right_answer(centre_at_rest(2, 0));
    for (double away : {1e-4, 1e-6, 1e-9}) {
        Solution const near = solve(builtin_scene(centre_at_rest(2, away)));
        double worst = 0;
        for (std::size_t k = 0; k < at.circular_spline.landmarks.size(); ++k)
            worst = std::max(
                worst, (at.circular_spline.outline[0][static_cast<std::size_t>(at.circular_spline.landmarks[k])] -
                        near.circular_spline.outline[0][static_cast<std::size_t>(near.circular_spline.landmarks[k])])
                           .norm());
        CHECK(worst <= 20 * away + 1e-10);
    }
}

HARD_ROW("w0 = 0", "a rigid ring has no wave generator", "refused: above 0")
{
    refused({"wave_generator.radial_deformation=0"}, "above 0");
}

HARD_ROW("w0 = 1e-9", "rigid limit: the teeth never leave their spaces",
         "refused: no land with the radius that leaves one")
{
    refused({"wave_generator.radial_deformation=1e-9", "!circular_spline.inner_radius"}, "no tip land is left");
}

HARD_ROW("w0 = 1e-9 and a tip circle beyond the tips", "rigid limit", "refused: no tooth enters")
{
    refused({"wave_generator.radial_deformation=1e-9", "circular_spline.inner_radius=25.3"}, "no tooth enters");
}

HARD_ROW("w0 too small", "teeth never leave the tooth spaces", "refused: tip circle")
{
    refused({"wave_generator.radial_deformation=0.15"}, "tip circle");
}

HARD_ROW("w0 makes the ring hollow", "curvature of the neutral curve changes sign", "refused: hollow")
{
    refused({"wave_generator.radial_deformation=6", "!circular_spline.inner_radius"}, "hollow");
}

HARD_ROW("w0 all but makes the ring hollow", "teeth sweep the whole circular spline away", "refused: no land")
{
    refused({"wave_generator.radial_deformation=4.8", "!circular_spline.inner_radius"}, "land");
}

HARD_ROW("30 teeth", "a ring of 3 mm radius: nothing is of first order any more", "right answer")
{
    right_answer(own_tip_circle + Overrides{"drive.flexspline_teeth=30", "drive.circular_spline_teeth=32"});
}

HARD_ROW("5000 teeth", "r_m = 625 mm against a tooth of 0.5 mm: two digits more lost",
         "right answer with the larger error stated")
{
    right_answer(own_tip_circle + Overrides{"drive.flexspline_teeth=5000", "drive.circular_spline_teeth=5002"});
}

HARD_ROW("ten teeth apart", "five pitches a lobe: teeth jump over spaces", "right answer")
{
    right_answer(own_tip_circle +
                 Overrides{"drive.circular_spline_teeth=210", "wave_generator.radial_deformation=1.25"});
}

HARD_ROW("rollers on the axis",
         "the third derivative of w jumps at u = 0 where tip land and corners and flanks have contacts", "right answer")
{
    right_answer({"wave_generator.family=four-roller", "wave_generator.roller_angle_deg=0"});
}

HARD_ROW("rollers almost on the axis", "two jumps 4e-9 rad apart", "right answer")
{
    right_answer({"wave_generator.family=four-roller", "wave_generator.roller_angle_deg=1e-7"});
}

HARD_ROW("rollers far from the axis", "the fourth harmonic is larger than usual", "right answer")
{
    right_answer({"wave_generator.family=four-roller", "wave_generator.roller_angle_deg=40"});
}

HARD_ROW("discs", "two jumps on the way of the main contacts", "right answer")
{
    right_answer({"wave_generator.family=two-disc", "wave_generator.wrap_angle_deg=30"});
}

HARD_ROW("denormal numbers in a cam table", "5e-324 mm", "right answer")
{
    TemporaryFolder const folder;
    right_answer(
        table_cam(folder, "0,0.25\n30,0.125\n45,5e-324\n60,-0.125\n90,-0.25\n120,-0.125\n135,-5e-324\n150,0.125\n"));
}

HARD_ROW("noise in a cam table", "curvature between rows changes sign", "refused: hollow at an angle")
{
    TemporaryFolder const folder;
    std::ostringstream rows;
    for (int i = 0; i < 180; ++i)
        rows << i << "," << 0.25 * std::cos(i * 3.14159265358979 / 90) + ((i * 7919) % 11 - 5) * 1e-3 << "\n";
    refused(table_cam(folder, rows.str()), "hollow");
}

// the tooth

HARD_ROW("fast contact",
         "a straight flank turns by 1 degree while its whole length touches: points round 100 times worse along it",
         "right answer")
{
    right_answer(fast_contact);
}

HARD_ROW("tangent of length 0", "concave_offset written out with the digits of tangent", "right answer")
{
    right_answer({"flexspline.profile.concave_offset=0.68352501"});
}

HARD_ROW("arcs that do not meet", "the thesis prints 0.0671 for l_f", "refused: do not meet")
{
    refused({"flexspline.profile.concave_offset=0.0671"}, "do not meet");
}

HARD_ROW("arc radius 1e9", "larger than any drive", "refused: larger than any drive")
{
    refused({"flexspline.profile.convex_radius=1e9"}, "larger than any drive");
}

HARD_ROW("pointed tooth", "tip land of width 0 to the last bit", "right answer")
{
    right_answer(straight("0.25", "30", "0.28867513459481287"));
}

HARD_ROW("tip land of 1e-12 mm", "a line shorter than the roundings of the gear's radius", "right answer")
{
    right_answer(straight("0.25", "30", "0.28867513459581287"));
}

HARD_ROW("tip stays inside", "curves float above the tip circle and the walk got under them", "refused: no tip land")
{
    refused({"flexspline.profile.addendum=0.2129", "!flexspline.profile.tip_line_from",
             "flexspline.profile.convex_radius=0.2934", "flexspline.profile.convex_offset=0.0987",
             "flexspline.profile.concave_radius=0.5228", "flexspline.profile.concave_rise=0.0686",
             "wave_generator.radial_deformation=0.1907", "!circular_spline.inner_radius"},
            "no tip land");
}

HARD_ROW("flank that ends above the tip circle",
         "its side clearance lifts its end at the tooth's root: the walk along the tip circle passes under it",
         "refused: with the radius where it ends")
{
    refused({"wave_generator.radial_deformation=0.31", "circular_spline.backlash_offset=0.05"},
            "a flank ends at a radius of 25.04");
    right_answer({"wave_generator.radial_deformation=0.31", "circular_spline.backlash_offset=0.05",
                  "circular_spline.inner_radius=25.05"});
}

HARD_ROW("swallowtail next to a cusp", "undercut: two branches cross 4 um from the cusp of one",
         "right answer: the usable part is kept")
{
    Solution const s = right_answer(swallowtail);
    bool cusp = false;
    for (BranchRecord const& branch : s.branches)
        cusp = cusp || branch.begins == "cusp" || branch.ends == "cusp";
    CHECK(cusp);
}

HARD_ROW("repeated point", "a measured flank with a point twice", "refused: the line that repeats")
{
    TemporaryFolder const folder;
    refused(points_file(folder, "0.05,0.22\n0.12,0.12\n0.12,0.12\n0.17,0\n0.25,-0.15\n0.33,-0.3\n"),
            "repeats the point");
}

HARD_ROW("points 1e-15 apart", "neighbours that differ in their last bits only: a knot interval of 1e-15",
         "right answer")
{
    TemporaryFolder const folder;
    right_answer(points_file(folder, "0.05,0.22\n0.12,0.12\n0.12,0.119999999999999\n0.17,0\n0.25,-0.15\n0.33,-0.3\n"));
}

HARD_ROW("denormal coordinates", "a pointed measured flank whose tip stands at 5e-324", "right answer")
{
    TemporaryFolder const folder;
    right_answer(points_file(folder, "5e-324,0.225\n0.06,0.12\n0.12,0.02\n0.17,-0.08\n0.22,-0.19\n0.28,-0.303\n"));
}

// the tooth space

HARD_ROW("conjugate zones overlap", "both zones of the convex arc bound the space",
         "right answer: both on the boundary")
{
    Solution const s = right_answer(Overrides{});
    int used = 0;
    for (ConjugateZone const& zone : s.zones)
        used += zone.segment_name == "right convex arc" && zone.on_boundary ? 1 : 0;
    CHECK(used == 2);
}

HARD_ROW("no conjugate zone on part of the flank", "around the joint of the arcs no position touches",
         "right answer: the gap is in t")
{
    Solution const s = right_answer(Overrides{});
    double reached = 1;
    for (ConjugateZone const& zone : s.zones)
        if (zone.segment_name == "right concave arc")
            reached = std::min({reached, zone.t_begin, zone.t_end});
    CHECK(reached > 0.1);
}

HARD_ROW("offset closes the lands", "neighbouring spaces overlap at the tip circle", "refused: pointed at a radius")
{
    refused({"circular_spline.backlash_offset=0.045"}, "pointed");
}

HARD_ROW("huge offset", "larger than the tooth", "refused: tip circle")
{
    refused({"circular_spline.backlash_offset=0.25"}, "tip circle");
}

HARD_ROW("offset of 1e-15 mm", "below every rounding", "right answer next to the base result")
{
    Solution const base = solve(builtin_scene());
    CHECK(difference(base, right_answer({"circular_spline.backlash_offset=1e-15"})) < 1e-9);
}

HARD_ROW("flank lost to side clearance", "a clearance of 20 um closes over a corner path of 3.4 um",
         "refused: place and length")
{
    refused(short_corner_path + Overrides{"circular_spline.backlash_offset=0.02"},
            "would remove a part of the flank 0.0033");
}

HARD_ROW("the same without clearance", "the corner path of 3.4 um is there", "right answer")
{
    right_answer(short_corner_path);
}

HARD_ROW("side clearance at that limit",
         "1e-9 mm below and above the offset at which the stretch has a few nanometres left",
         "right answer below and refused with the place above")
{
    auto const with = [](double offset) {
        return short_corner_path + Overrides{"circular_spline.backlash_offset=" + digits17(offset)};
    };
    auto const solvable = [&](double offset) {
        try {
            (void)solve(builtin_scene(with(offset)));
            return true;
        } catch (std::runtime_error const& error) {
            INFO(offset << ": " << error.what());
            REQUIRE_THAT(error.what(), ContainsSubstring("near ("));
            return false;
        }
    };
    double low = 0, high = 0.02;
    while (high - low > 1e-10)
        (solvable(0.5 * (low + high)) ? low : high) = 0.5 * (low + high);
    CHECK(high > 0.019);
    right_answer(with(low - 1e-9), "limit " + three_digits(low) + " mm");
    refused(with(high + 1e-9), "near (");
    // past the last nanometres, where three branches meet in a point, the refusal names what is swallowed
    refused(with(high + 1e-7), "would remove a part of the flank");
}

HARD_ROW("corner beside the tip circle", "the corner between flank and corner path lies 2 um above the tip circle",
         "right answer")
{
    right_answer({"circular_spline.inner_radius=25.0485"});
}

HARD_ROW("nearly self-touching spaces",
         "a tip land of less than a micrometre: just above the radius at which the teeth are pointed", "right answer")
{
    double pointed = 0;
    try {
        (void)solve(builtin_scene({"circular_spline.backlash_offset=0.045"}));
    } catch (std::runtime_error const& error) {
        std::string const text = error.what();
        pointed = std::stod(text.substr(text.find("radius of ") + 10));
    }
    REQUIRE(pointed > 25);
    Solution const s = right_answer(
        {"circular_spline.backlash_offset=0.045", "circular_spline.inner_radius=" + digits17(pointed + 2e-6)});
    CHECK(s.geometry.land_half_angle > 0);
    CHECK(s.geometry.land_half_angle * pointed < 1e-3);
}

// sizes

HARD_ROW("module 1e-4", "scale invariance: a drive of 10 um", "the same drive to 1e-13 relative")
{
    double const factor = 1e-4 / 0.25;
    Solution const small = right_answer(scaled(factor));
    CHECK(difference(solve(builtin_scene()), small, factor) / 25 < 1e-13);
}

HARD_ROW("module 1e3", "scale invariance: a drive of 200 m", "the same drive to 1e-13 relative")
{
    double const factor = 1e3 / 0.25;
    Solution const large = right_answer(scaled(factor));
    CHECK(difference(solve(builtin_scene()), large, factor) / 25 < 1e-13);
}

/// How far the ends of the width are apart, mid-land to mid-land.
double largest_step(Solution const& solution)
{
    double largest = 0;
    auto const& slices = solution.circular_spline.outline;
    for (std::size_t i = 0; i < slices.front().size(); ++i)
        largest = std::max(largest, std::abs(slices.back()[i].norm() - slices.front()[i].norm()));
    return largest;
}

HARD_ROW("another unit of length", "powers of two change no digit", "the same bits")
{
    Solution const base = solve(builtin_scene());
    for (double factor : {0x1p-10, 0x1p12})
        CHECK(difference(base, right_answer(scaled(factor)), factor) == 0);
}

HARD_ROW("coarse tolerance", "a handful of points", "right answer")
{
    right_answer({"solver.tolerance=0.02"});
}

HARD_ROW("fine tolerance", "chord error near the rounding of the coordinates", "right answer")
{
    right_answer({"solver.tolerance=1e-11"});
}

// along the axis

HARD_ROW("tilt", "angles 0 and 1e-12 and -0.2 degrees, both kinds",
         "right answer: 0 has the bits of no tilt, 1e-12 moves nothing that can be measured")
{
    for (std::string const kind : {"radial", "draft"}) {
        auto const tilted = [&](std::string const& angle) {
            return right_answer({"tilt.angle_deg=" + angle, "tilt.kind=" + kind, "slices.count=3"},
                                kind + " tilt " + angle + " deg");
        };
        Solution const upright = right_answer({"slices.count=3"});
        Solution const zero = tilted("0");
        CHECK(zero.circular_spline.outline == upright.circular_spline.outline);
        CHECK(largest_step(tilted("1e-12")) < 1e-12);
        // the mid-land moves by T tan 0.2 deg along the radius, as all of a radial tilt; of a draft, whose flanks move
        // along their normals, the bottom moves a little more
        double const shift = 2 * 3.5 * std::tan(0.2 * std::numbers::pi / 180);
        Solution const leaning = tilted("-0.2");
        auto const& slices = leaning.circular_spline.outline;
        CHECK(std::abs(slices.back().front().norm() - slices.front().front().norm()) == Approx(shift).epsilon(1e-12));
        CHECK(largest_step(leaning) == Approx(shift).epsilon(kind == "radial" ? 1e-9 : 2e-3));
    }
}

HARD_ROW("slices", "one and 1000", "right answer: one has the bits of none")
{
    Solution const base = solve(builtin_scene());
    CHECK(same_bits(base, right_answer({"slices.count=1", "slices.surface=per-slice"})));
    Solution const many = right_answer({"slices.count=1000", "solver.tolerance=1e-4"});
    CHECK(many.circular_spline.outline.size() == 1000);
}

HARD_ROW("slices of a cone", "100 slices whose conjugate zones appear and vanish",
         "every slice is its own right answer")
{
    Overrides const cone{"coning.model=linear", "coning.bottom_to_middle=9", "slices.count=100",
                         "slices.surface=per-slice", "solver.tolerance=1e-4"};
    Solution const solution = right_answer(cone, "100 slices");
    for (auto const& slice : solution.circular_spline.outline)
        CHECK(slice.size() == solution.circular_spline.outline.front().size());
}

HARD_ROW("few teeth on a cone",
         "81 teeth: flanks end 40 um farther out beside the tooth's middle than on it - found by a random sweep",
         "right answer: the tip circle follows their ends")
{
    Overrides const design{"drive.module=1.371972383",
                           "drive.flexspline_teeth=81",
                           "drive.circular_spline_teeth=84",
                           "wave_generator.waves=3",
                           "wave_generator.radial_deformation=2.551947338",
                           "flexspline.wall=4.713309097",
                           "flexspline.profile.addendum=1.166447134",
                           "flexspline.profile.dedendum=1.700643101",
                           "flexspline.profile.convex_radius=1.631748399",
                           "flexspline.profile.convex_offset=0.5243742061",
                           "flexspline.profile.concave_radius=3.018754574",
                           "flexspline.profile.concave_rise=0.3413320809",
                           "flexspline.profile.tip_line_from=0.9205415487",
                           "!circular_spline.inner_radius",
                           "!flexspline.cup",
                           "!bearing",
                           "!load",
                           "circular_spline.width=7.722503",
                           "coning.model=linear",
                           "coning.bottom_to_middle=11.540186",
                           "slices.count=5"};
    for (char const* const surface : {"per-slice", "ruled"})
        for (char const* const clearance : {"0", "0.1"})
            right_answer(design + Overrides{std::string("slices.surface=") + surface,
                                            std::string("circular_spline.backlash_offset=") + clearance},
                         std::string(surface) + ", side clearance " + clearance + " mm");
}

HARD_ROW("far more teeth outside", "50 000 pitches a lobe - found by fuzzing: 10 s and 2 GB before it was refused",
         "refused: by how many teeth")
{
    refused({"drive.circular_spline_teeth=99998", "!circular_spline.inner_radius"}, "by 49899 teeth");
}

HARD_ROW("a million points", "measured points to the nanometre - found by fuzzing: minutes before an answer",
         "refused: how many are computed")
{
    TemporaryFolder const folder;
    std::string rows;
    constexpr int count = 1000000;
    for (int i = 0; i < count; ++i)
        rows += std::to_string(0.1 + 0.2e-6 * i) + "," + std::to_string(0.2 - 0.5e-6 * i) + "\n";
    refused(points_file(folder, rows), "write at most 10000 lines");
}

HARD_ROW("points without end", "a device in place of a file of points has no line that ends",
         "refused: no file of numbers")
{
    refused({"!flexspline.profile", "flexspline.profile.family=points", "flexspline.profile.file=/dev/zero"},
            "no file of numbers");
}

}  // namespace hdconj::test::designs_cases
