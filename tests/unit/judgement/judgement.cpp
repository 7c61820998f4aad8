// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/judgement.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <sstream>

#include "drive/drive.hpp"
#include "hdconj/check.hpp"
#include "hdconj/error.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/result_files.hpp"
#include "hdconj/solve.hpp"
#include "hdconj/units.hpp"
#include "judgement/checks.hpp"
#include "judgement/judgement.hpp"
#include "scene/usual_drive.hpp"
#include "support/catch.hpp"
#include "support/read_hdf5.hpp"
#include "support/temporary_folder.hpp"
#include "support/type50.hpp"

namespace hdconj::test::judgement_cases {
namespace {

using Keys = std::vector<std::string>;

std::optional<Note> note_of(Notes const& notes, NoteCode code)
{
    auto const found = std::find_if(notes.begin(), notes.end(), [code](Note const& note) { return note.code == code; });
    return found == notes.end() ? std::nullopt : std::optional(*found);
}

/// Straight teeth of a printed drive.
Scene printed(Keys const& more = {})
{
    std::string const text =
        "[drive]\nname = \"printed\"\nmodule = 1\nflexspline_teeth = 60\ncircular_spline_teeth = 62\n"
        "[flexspline]\nwall = 0.8\n[flexspline.profile]\nfamily = \"straight\"\naddendum = 0.8\ndedendum = 1.1\n"
        "thickness = 1.5\npressure_angle_deg = 28.6\n"
        "[wave_generator]\nfamily = \"cosine\"\nradial_deformation = 1.0\nwaves = 2\n[solver]\ntolerance = 1e-5\n";
    auto const reading = examine_scene(text, "printed", {}, more);
    if (!reading.faults.empty())
        throw InputError(reading.faults);
    return reading.scene;
}

/// What ends the solution of @p scene.
NumericalError failure(Scene const& scene)
{
    try {
        (void)solve(scene);
    } catch (NumericalError const& error) {
        return error;
    }
    throw std::logic_error("it was solved");
}

std::string page()
{
    std::ifstream file(std::string(HDCONJ_SOURCE_DIR) + "/docs/reference/judgement.md");
    std::ostringstream text;
    for (std::string word; file >> word;)  // lines are broken somewhere
        text << word << ' ';
    return text.str();
}

std::string words(DesignRange const& range)
{
    std::ostringstream text;
    text.precision(3);
    if (std::isfinite(range.low) && std::isfinite(range.high))
        text << range.low << " to " << range.high;
    else if (std::isfinite(range.low))
        text << "at least " << range.low;
    else if (std::isfinite(range.high))
        text << "at most " << range.high;
    else
        text << "any";
    return text.str();
}

std::string row_of(DesignLimit const& limit)
{
    return "| `" + std::string(to_string(limit.code)) + "` | " + limit.unit + " | " + words(limit.usual) + " | " +
           words(limit.accepted) + " |";
}

std::string source_of(DesignLimit const& limit)
{
    return "- `" + std::string(to_string(limit.code)) + "`: " + limit.figure + ". Source: " + limit.source + ".";
}

}  // namespace

TEST_CASE("the page of limits holds the program's limits, word for word", "[judgement]")
{
    std::string const text = page();
    std::size_t rows = 0;
    for (std::size_t at = text.find("- `"); at != std::string::npos; at = text.find("- `", at + 1))
        ++rows;
    CHECK(rows == design_limits().size());
    CHECK(design_limits().size() == words_of<NoteCode>.size());
    for (DesignLimit const& limit : design_limits()) {
        CHECK(&limit - design_limits().data() == static_cast<std::ptrdiff_t>(limit.code));
        CHECK_THAT(text, ContainsSubstring(row_of(limit)));
        CHECK_THAT(text, ContainsSubstring(source_of(limit)));
    }
}

TEST_CASE("prints the table of docs/reference/judgement.md", "[.][judgement-table]")
{
    for (DesignLimit const& limit : design_limits())
        std::cout << row_of(limit) << '\n' << source_of(limit) << '\n';
}

TEST_CASE("with the usual radial deformation a tooth rests at the major axis, for any number of waves", "[judgement]")
{
    int const waves = GENERATE(1, 2, 3);
    int const z_f = 60000;  // a rack: teeth do not turn
    Drive const drive{"", 0.25, z_f, z_f + waves};
    double const w0 = scene::usual_deformation(drive);
    CHECK(w0 == Approx(0.25 * waves / 2));
    CHECK(drive.module * z_f / 2 + w0 == Approx(drive.module * drive.circular_spline_teeth / 2).epsilon(1e-12));
    double const r_m = drive.module * z_f / 2, ratio = static_cast<double>(z_f) / drive.circular_spline_teeth;
    auto const speed = [&](double factor) {
        Exact const motion(wavegen::NeutralCurve<wavegen::CosineCam>({w0 * factor, waves}, r_m), ratio);
        double const u = 0.01;
        return (motion.pose(u)(Vec2(0, 0)).x() - motion.pose(0)(Vec2(0, 0)).x()) / (w0 * u);
    };
    CHECK(std::abs(speed(1)) < 1e-3);
    CHECK(std::abs(speed(0.9)) > 0.05);
    CHECK(speed(0.9) * speed(1.1) < 0);
}

TEST_CASE("the built-in drive and printed straight teeth draw no warning", "[judgement]")
{
    CHECK(solve(builtin_scene()).judgement.empty());
    CHECK(warnings_of(solve(printed()).judgement) == 0);
}

TEST_CASE("a scene's own notes name figure, limit and what to write", "[judgement]")
{
    auto const [keys, code, severity, figure, set] = GENERATE(table<Keys, NoteCode, Severity, double, Keys>({
        {{"wave_generator.radial_deformation=2.0"},
         NoteCode::deformation,
         Severity::warning,
         2.0,
         {"wave_generator.radial_deformation=1"}},
        {{"wave_generator.radial_deformation=0.7"},
         NoteCode::deformation,
         Severity::information,
         0.7,
         {"wave_generator.radial_deformation=1"}},
        {{"drive.circular_spline_teeth=64"},
         NoteCode::deformation,
         Severity::information,
         0.5,
         {"drive.circular_spline_teeth=62"}},
        {{"drive.circular_spline_teeth=64"}, NoteCode::tooth_difference, Severity::information, 2.0, {}},
        {{"flexspline.profile.thickness=0.95", "flexspline.profile.pressure_angle_deg=28"},
         NoteCode::tip_land,
         Severity::warning,
         0.95 - 1.6 * std::tan(from_deg(28)),
         {"flexspline.profile.addendum=0.498"}},
    }));
    auto const note = note_of(judge(printed(keys)), code);
    REQUIRE(note);
    INFO(describe({*note}));
    CHECK(note->severity == severity);
    CHECK(note->figure == Approx(figure).margin(1e-9));
    CHECK(note->set == set);
    CHECK_FALSE(note->cause.empty());
    CHECK_FALSE(note->advice.empty());
}

TEST_CASE("the wall's stress is that of the neutral curve's change of curvature", "[judgement]")
{
    Scene const scene = printed({"flexspline.wall=1.5"});
    auto const note = note_of(judge(scene), NoteCode::wall_stress);
    REQUIRE(note);
    Solution const solution = solve(scene);
    // the circle through three neighbouring points of the neutral curve at its major axis
    auto const& curve = solution.neutral_curve;
    std::size_t const top = static_cast<std::size_t>(
        std::max_element(curve.begin(), curve.end(), [](Vec2 const& a, Vec2 const& b) { return a.y() < b.y(); }) -
        curve.begin());
    std::size_t const step = curve.size() / 180;
    Vec2 const a = curve[(top + curve.size() - step) % curve.size()], b = curve[top],
               c = curve[(top + step) % curve.size()];
    Vec2 const ab = b - a, bc = c - b, ac = c - a;
    double const curvature = 2 * std::abs(ab.x() * bc.y() - ab.y() * bc.x()) / (ab.norm() * bc.norm() * ac.norm());
    double const change = curvature - 1 / solution.geometry.r_m;
    CHECK(note->figure == Approx(206e3 * 0.75 * change).epsilon(0.12));  // first order in w0/r_m = 0.035
    CHECK(note->set.size() == 1);
    CHECK_FALSE(note_of(judge(printed(note->set)), NoteCode::wall_stress));
}

TEST_CASE("the wall is judged by the fatigue strength that the scene gives", "[judgement]")
{
    auto const type_50 = [](Keys const& keys) {
        return examine_scene_file(HDCONJ_SOURCE_DIR "/data/scenes/type-50.toml", keys).scene;
    };
    auto const limit = [](Scene const& scene) {
        return design_limits(scene)[static_cast<std::size_t>(NoteCode::wall_stress)];
    };
    Scene const usual = type_50({});
    CHECK_FALSE(note_of(judge(usual), NoteCode::wall_stress));
    CHECK(limit(usual).usual.high == design_limits()[static_cast<std::size_t>(NoteCode::wall_stress)].usual.high);
    // E c w0 (n^2 - 1)/r_m^2
    double const stress = 206e3 * 0.35 * 0.25 * 3 / (24.347 * 24.347);
    for (auto const& [strength, severity] :
         {std::pair(1.9 * stress, Severity::information), std::pair(1.4 * stress, Severity::warning)}) {
        Scene const scene = type_50({"flexspline.cup.fatigue_strength=" + std::to_string(strength)});
        auto const note = note_of(judge(scene), NoteCode::wall_stress);
        REQUIRE(note);
        CHECK(note->severity == severity);
        CHECK(note->figure == Approx(stress).epsilon(1e-9));
        CHECK(note->limit == Approx(strength / (severity == Severity::warning ? 1.5 : 2)).epsilon(1e-6));
        CHECK_THAT(limit(scene).source, ContainsSubstring("flexspline.cup.fatigue_strength"));
        Keys keys = note->set;
        keys.push_back("flexspline.cup.fatigue_strength=" + std::to_string(strength));
        CHECK_FALSE(note_of(judge(type_50(keys)), NoteCode::wall_stress));
    }
    CHECK_FALSE(note_of(judge(type_50({"flexspline.cup.fatigue_strength=2000"})), NoteCode::wall_stress));
}

TEST_CASE("tips leave the tip circle where the cam says", "[judgement]")
{
    Scene const scene = printed({"circular_spline.inner_radius=29.82"});
    auto const note = note_of(judge(scene), NoteCode::late_mesh);
    REQUIRE(note);
    // r_m + w0 cos(2 u) + pitch line + h_a = m z_f/2 + h_a + w0 cos(2 u)
    CHECK(note->figure == Approx(std::acos(29.82 - 30.8) / std::numbers::pi).epsilon(1e-3));
    CHECK_FALSE(note_of(judge(printed(note->set)), NoteCode::late_mesh));
}

TEST_CASE("a cam that is turned, or has two lobes in a table of a turn, leaves the tip circle as before", "[judgement]")
{
    TemporaryFolder const folder;
    auto const tabled = [&](double major_deg, int waves, std::string const& radius) {
        std::ofstream file(folder / "cam.csv");
        file.precision(12);
        for (int i = 0; i < 360 / waves; i += 5)
            file << i << "," << std::cos(2 * from_deg(i - major_deg)) << "\n";
        file.close();
        return printed({"!wave_generator.radial_deformation", "wave_generator.family=table",
                        "wave_generator.file=" + (folder / "cam.csv").string(),
                        "wave_generator.waves=" + std::to_string(waves), "circular_spline.inner_radius=" + radius});
    };
    for (auto const& [major, waves] : {std::pair(0.0, 2), std::pair(44.0, 2), std::pair(-31.0, 2), std::pair(0.0, 1)}) {
        INFO(major << " degrees, " << waves << " waves");
        CHECK_FALSE(note_of(judge(tabled(major, waves, "30")), NoteCode::late_mesh));
        auto const note = note_of(judge(tabled(major, waves, "29.82")), NoteCode::late_mesh);
        REQUIRE(note);
        CHECK(note->figure == Approx(std::acos(29.82 - 30.8) / std::numbers::pi).epsilon(5e-3));
        REQUIRE(note->set.size() == 1);
        std::string const radius = note->set.front().substr(note->set.front().find('=') + 1);
        CHECK_FALSE(note_of(judge(tabled(major, waves, radius)), NoteCode::late_mesh));
    }
}

TEST_CASE("notes that write the tip circle write the same one", "[judgement]")
{
    Note smaller, larger;
    smaller.advice = "write circular_spline.inner_radius = 24.2007, or a smaller addendum";
    smaller.set = {"circular_spline.inner_radius=24.2007"};
    larger.advice = "write circular_spline.inner_radius = 24.2058";
    larger.set = {"circular_spline.inner_radius=24.2058"};
    Notes notes{smaller, larger};
    Scene const scene = printed();
    judgement::agree_on_tip_circle({scene, PairGeometry{}, profile::Profile{}, wavegen::AnyWaveShape{}}, notes);
    CHECK(notes[0].set == larger.set);
    CHECK(notes[0].advice == "write circular_spline.inner_radius = 24.2058, or a smaller addendum");
    CHECK(notes[1].advice == larger.advice);
}

TEST_CASE("advice on the deformation writes the tip circle that goes with it", "[judgement]")
{
    constexpr double usual = 25.025;
    auto const followed = [&](Keys keys, Keys const& set) {
        REQUIRE(set.size() >= 2);
        CHECK(set[0] == "wave_generator.radial_deformation=0.25");
        double const tip = std::stod(set[1].substr(set[1].find('=') + 1));
        keys.insert(keys.end(), set.begin(), set.end());
        Solution const solution = solve(builtin_scene(keys));
        CHECK(solution.geometry.space_depth > 1.2 * solution.scene.drive.module);
        CHECK_FALSE(note_of(solution.judgement, NoteCode::land));
        return tip;
    };
    // the land's note is for the deformation as it is, at which a usual tip circle is wider than what it asks for
    Keys const deep{"wave_generator.radial_deformation=0.75", "circular_spline.inner_radius=25.45"};
    Solution const solution = solve(builtin_scene(deep));
    auto const deformation = note_of(solution.judgement, NoteCode::deformation);
    REQUIRE(deformation);
    CHECK(followed(deep, deformation->set) == usual);
    CHECK_THAT(deformation->advice, ContainsSubstring("inner_radius = 25.025"));
    auto const land = note_of(solution.judgement, NoteCode::land);
    REQUIRE(land);
    Keys wider = deep;
    wider.push_back(land->set.front());
    CHECK_FALSE(note_of(solve(builtin_scene(wider)).judgement, NoteCode::land));
    // where the side clearance takes the land, a smaller one comes with it
    Keys const clear{"wave_generator.radial_deformation=0.7274", "circular_spline.inner_radius=25.4354",
                     "flexspline.wall=0.6", "circular_spline.backlash_offset=0.06"};
    NumericalError const failed = failure(builtin_scene(clear));
    INFO(failed.what());
    CHECK(failed.set().size() == 3);
    CHECK(followed(clear, failed.set()) == usual);
}

TEST_CASE("a tip circle that leaves no land is not advised", "[judgement]")
{
    // of late mesh alone 30.2, and the teeth sweep more
    Keys keys{"flexspline.profile.thickness=1.95", "flexspline.profile.pressure_angle_deg=20",
              "flexspline.profile.addendum=0.95", "flexspline.profile.dedendum=1.375",
              "wave_generator.radial_deformation=0.95"};
    keys.emplace_back("circular_spline.inner_radius=30");
    NumericalError const swept = failure(printed(keys));
    INFO(swept.what());
    CHECK(swept.code() == ErrorCode::no_land);
    REQUIRE_FALSE(swept.set().empty());
    keys.back() = swept.set().front();
    CHECK_THAT(swept.remedy(), ContainsSubstring("inner_radius = " + keys.back().substr(keys.back().find('=') + 1)));
    CHECK_NOTHROW(solve(printed(keys)));
}

TEST_CASE("a side clearance that takes the land is named, and a smaller one that leaves it", "[judgement]")
{
    for (std::string const clearance : {"0.06", "0.1", "0.12"}) {
        Keys keys{"circular_spline.backlash_offset=" + clearance};
        NumericalError const failed = failure(builtin_scene(keys));
        INFO(failed.what());
        CHECK(failed.code() == ErrorCode::no_land);
        CHECK_THAT(failed.cause(), ContainsSubstring("the side clearance of " + clearance + " mm"));
        REQUIRE(failed.set().size() == 1);
        std::string const value = failed.set().front().substr(failed.set().front().find('=') + 1);
        CHECK(failed.set().front() == "circular_spline.backlash_offset=" + value);
        CHECK(failed.remedy().starts_with("write circular_spline.backlash_offset = " + value + "; or "));
        keys.push_back(failed.set().front());
        CHECK_FALSE(note_of(solve(builtin_scene(keys)).judgement, NoteCode::land));
    }
    // without side clearance, where it is not certain, and where the teeth are too thick without it
    Keys const thick{"flexspline.profile.thickness=1.95", "flexspline.profile.pressure_angle_deg=20",
                     "flexspline.profile.addendum=0.95", "flexspline.profile.dedendum=1.375",
                     "wave_generator.radial_deformation=0.95"};
    for (std::string const clearance : {"0", "0.01"}) {
        Keys keys = thick;
        keys.push_back("circular_spline.backlash_offset=" + clearance);
        CHECK_THAT(failure(printed(keys)).what(), !ContainsSubstring("side clearance of"));
    }
}

TEST_CASE("the tip circle above which a land is left is that with the side clearance", "[judgement]")
{
    for (std::string const clearance : {"0", "0.02", "0.04"}) {
        Keys keys{"wave_generator.radial_deformation=0.03", "circular_spline.backlash_offset=" + clearance};
        NumericalError const failed = failure(builtin_scene(keys));
        INFO(failed.what());
        REQUIRE(failed.code() == ErrorCode::no_land);
        std::string const text = failed.remedy(), before = "circular_spline.inner_radius above ";
        auto const at = text.find(before);
        REQUIRE(at != std::string::npos);
        double const least = std::stod(text.substr(at + before.size()));
        keys.push_back("circular_spline.inner_radius=" + std::to_string(least + 0.001));
        CHECK_NOTHROW(solve(builtin_scene(keys)));
        keys.back() = "circular_spline.inner_radius=" + std::to_string(least - 0.001);
        CHECK(failure(builtin_scene(keys)).code() == ErrorCode::no_land);
    }
    // further out than the tips reach
    Keys const wide{"wave_generator.radial_deformation=0.03", "circular_spline.backlash_offset=0.06"};
    CHECK_THAT(failure(builtin_scene(wide)).remedy(), !ContainsSubstring("inner_radius above"));
}

TEST_CASE("a tip circle that leaves more land than the usual one is kept with the usual deformation", "[judgement]")
{
    Keys const wide{"circular_spline.inner_radius=25.08", "circular_spline.backlash_offset=0.01"};
    Keys small = wide;
    small.emplace_back("wave_generator.radial_deformation=0.05");
    NumericalError const failed = failure(builtin_scene(small));
    INFO(failed.what());
    CHECK(failed.set() == Keys{"wave_generator.radial_deformation=0.25"});
    CHECK_FALSE(note_of(solve(builtin_scene(wide)).judgement, NoteCode::land));
}

TEST_CASE("a tilt that makes the tip circle of one end too small is a warning", "[judgement]")
{
    auto const tilted = [](std::string const& degrees) {
        return builtin_scene({"slices.count=3", "tilt.angle_deg=" + degrees});
    };
    CHECK_FALSE(note_of(judge(tilted("0.2")), NoteCode::late_mesh));
    for (std::string const degrees : {"10", "-10"}) {
        auto const note = note_of(judge(tilted(degrees)), NoteCode::late_mesh);
        REQUIRE(note);
        CHECK(note->severity == Severity::warning);
        CHECK_THAT(note->cause, ContainsSubstring("the tilt makes the tip circle of one end 0.617 mm smaller"));
        CHECK_THAT(note->advice, ContainsSubstring("or tilt"));
    }
    // a part whose tilt the notes of z = 0 do not know
    Notes notes = judge(builtin_scene({"flexspline.cup.fatigue_strength=300"}));
    REQUIRE_FALSE(note_of(notes, NoteCode::late_mesh));
    std::size_t const others = notes.size();
    judgement::judge_late_mesh_again(notes, tilted("10"));
    CHECK(note_of(notes, NoteCode::late_mesh));
    CHECK(notes.size() == others + 1);
    judgement::judge_late_mesh_again(notes, tilted("0.2"));
    CHECK(notes.size() == others);
    // one slice has no tilt
    CHECK_FALSE(note_of(judge(builtin_scene({"tilt.angle_deg=10"})), NoteCode::late_mesh));
}

TEST_CASE("flank contact is the angle between the ends of the flank of the tooth space", "[judgement]")
{
    Solution const solution = solve(printed());
    // the branch point nearest to a point of the outline tells its angle
    auto const angle_at = [&](Vec2 const& p) {
        double nearest = std::numeric_limits<double>::infinity(), angle = 0;
        for (BranchRecord const& branch : solution.branches)
            for (std::size_t i = 0; branch.kind == "regular" && i < branch.point.size(); ++i)
                if (branch.segment_name == "right flank" && (branch.point[i] - p).norm() < nearest) {
                    nearest = (branch.point[i] - p).norm();
                    angle = branch.u[i];
                }
        return angle;
    };
    double angle = 0;
    auto const& points = solution.circular_spline.outline.front();
    for (OutlinePiece const& piece : solution.circular_spline.pieces)
        if (piece.kind == "flank" && points[piece.first].x() > 0)
            angle += std::abs(angle_at(points[piece.last]) - angle_at(points[piece.first]));
    CHECK(angle > from_deg(5));
    CHECK(solution.flank_contact.angle == Approx(angle).epsilon(0.02));  // branches are sampled
    double zones = 0;
    for (ConjugateZone const& zone : solution.zones)
        if (zone.kind == "regular" && zone.on_boundary && zone.segment_name == "right flank")
            zones += std::abs(zone.u_end - zone.u_begin);
    CHECK(solution.flank_contact.angle <= zones);
}

TEST_CASE("a drive whose corners alone mesh is not silent", "[judgement]")
{
    Solution solution = solve(printed({"flexspline.profile.pressure_angle_deg=14", "flexspline.wall=0.7"}));
    auto note = note_of(solution.judgement, NoteCode::flank_contact);
    REQUIRE(note);
    CHECK(note->set.empty());
    try_advice(solution);
    note = note_of(solution.judgement, NoteCode::flank_contact);
    REQUIRE(note);
    CHECK(note->severity == Severity::warning);
    CHECK(note->figure == 0);
    CHECK_THAT(note->cause, ContainsSubstring("no flank touches"));
    REQUIRE(note->set.size() == 1);
    Solution const better = solve(printed({note->set.front(), "flexspline.wall=0.7"}));
    CHECK(better.flank_contact.angle > 0);
    CHECK(warnings_of(better.judgement) == 0);
}

TEST_CASE("a wire that is too thick is named with the corner and the space", "[judgement]")
{
    Keys const wire{"wedm.wire_diameter=1.5", "wedm.spark_gap=0.01", "wedm.start_hole_radius=1.0", "wedm.lead_in=3.0"};
    Notes const notes = solve(printed(wire)).judgement;
    auto const corner = note_of(notes, NoteCode::sharp_corner), space = note_of(notes, NoteCode::narrow_space);
    REQUIRE(corner);
    REQUIRE(space);
    CHECK_THAT(corner->cause, ContainsSubstring("the wire of [wedm] leaves "));
    CHECK_THAT(space->cause, ContainsSubstring("a slot of 1.52 mm"));
    CHECK(space->figure < 1);
    // a root clearance leaves the corner sharp, a wire as thin as advised does not
    for (std::string const clearance : {"0", "0.1"}) {
        Keys keys = wire;
        keys.push_back("circular_spline.root_clearance=" + clearance);
        auto const there = note_of(solve(printed(keys)).judgement, NoteCode::sharp_corner);
        REQUIRE(there);
        INFO(there->advice);
        CHECK_THAT(there->advice, !ContainsSubstring("root_clearance = "));
        std::string const before = "of at most ";
        std::size_t const at = there->advice.find(before);
        REQUIRE(at != std::string::npos);
        double const thin = std::stod(there->advice.substr(at + before.size()));
        keys.front() = "wedm.wire_diameter=" + std::to_string(thin);
        CHECK_FALSE(note_of(solve(printed(keys)).judgement, NoteCode::sharp_corner));
        keys.front() = "wedm.wire_diameter=" + std::to_string(thin + 0.01);  // the next one on sale
        CHECK(note_of(solve(printed(keys)).judgement, NoteCode::sharp_corner));
    }
}

TEST_CASE("the space that a wire must enter is the narrowest of all slices", "[judgement]")
{
    Solution solution = solve(read_scene(HDCONJ_SOURCE_DIR "/data/scenes/type-50-coned.toml"));
    solution.scene.wedm = WireRequest{};
    auto const with_slot = [&](double slot) {
        solution.scene.wedm->wire_diameter = slot;
        Notes notes = solution.judgement;
        judgement::judge_narrow_space_again(notes, solution.scene, solution);
        return note_of(notes, NoteCode::narrow_space);
    };
    auto const wide = with_slot(0.6), middle = [&] {
        Solution one = solution;
        CircularSplineOutline& ring = one.circular_spline;
        std::size_t const at = ring.z.size() / 2;
        ring.outline = {ring.outline[at]};
        ring.z = {0};
        Notes notes;
        judgement::judge_narrow_space_again(notes, one.scene, one);
        return note_of(notes, NoteCode::narrow_space);
    }();
    REQUIRE(wide);
    REQUIRE(middle);
    CHECK(wide->figure < 0.99 * middle->figure);
    CHECK(middle->place == "tooth space");
    CHECK_THAT(wide->place, ContainsSubstring("tooth space at z = ") && ContainsSubstring(" mm"));
    CHECK_FALSE(with_slot(0.1));
    CHECK(with_slot(3));  // the mouth of the space is too narrow already
}

TEST_CASE("advice is not what the scene has", "[judgement]")
{
    // of few teeth, 26 degrees are as good as any
    Scene thirty =
        read_scene(HDCONJ_SOURCE_DIR "/data/scenes/involute.toml", {"flexspline.profile.pressure_angle_deg=26"});
    scene::Advice advice;
    thirty.drive.flexspline_teeth = 30;
    scene::add_pressure_angle(thirty, advice);
    CHECK(advice.set.empty());
    thirty.flexspline.profile.given.at("pressure_angle_deg").value = 20.0;
    scene::add_pressure_angle(thirty, advice);
    CHECK(advice.set.size() == 1);
}

TEST_CASE("advice for longer contact keeps the tip land", "[judgement]")
{
    // touch longer with an addendum of 0.9 modules, which leaves a tip land of 0.32
    Scene const scene = parse_scene(R"([drive]
name = "two notes"
module = 1.0
flexspline_teeth = 240
circular_spline_teeth = 242
[flexspline]
wall = 2.4
[flexspline.profile]
family = "straight"
addendum = 0.7751
dedendum = 1.1
pressure_angle_deg = 30
thickness = 1.358
[wave_generator]
family = "two-disc"
radial_deformation = 1.0
waves = 2
wrap_angle_deg = 20
)",
                                    "two notes");
    Notes const notes = judgement::notes_on(solve(scene));
    auto const note = std::ranges::find(notes, NoteCode::flank_contact, &Note::code);
    REQUIRE(note != notes.end());
    CHECK(note->set.empty());
}

TEST_CASE("a fault that the deformation does not make is not laid to it", "[judgement]")
{
    std::vector<std::string> const edits{"flexspline.wall=24.9", "wave_generator.radial_deformation=0.15"};
    Faults const faults = check_scene(read_scene(HDCONJ_SOURCE_DIR "/data/scenes/points.toml", edits));
    REQUIRE_FALSE(faults.empty());
    CHECK(faults.front().path == "flexspline.wall");
    CHECK_THAT(faults.front().reason, !ContainsSubstring("radial deformation"));
    Faults const tooth = check_scene(builtin_scene({"flexspline.profile.addendum=0.6", edits[1]}));
    REQUIRE_FALSE(tooth.empty());
    CHECK_THAT(tooth.front().remedy, !ContainsSubstring("radial_deformation"));
}

TEST_CASE("a failure names the unusual radial deformation first, in the right direction", "[judgement]")
{
    NumericalError const large =
        failure(builtin_scene({"wave_generator.radial_deformation=2.5", "!circular_spline.inner_radius"}));
    CHECK(large.cause().starts_with("likely because the radial deformation 2.5 mm is 10 times the usual"));
    CHECK_THAT(large.remedy(), ContainsSubstring("wave_generator.radial_deformation = 0.25"));
    CHECK(large.set() == Keys{"wave_generator.radial_deformation=0.25"});
    NumericalError const small =
        failure(builtin_scene({"wave_generator.radial_deformation=0.025", "!circular_spline.inner_radius"}));
    CHECK_THAT(small.cause(), ContainsSubstring("0.1 times the usual"));
    CHECK(small.set() == large.set());
    CHECK_NOTHROW(solve(builtin_scene(large.set())));
}

TEST_CASE("a tip circle that was made wide for the land stays with the usual deformation", "[judgement]")
{
    Keys const wide{"circular_spline.inner_radius=25.16", "circular_spline.backlash_offset=0.06"};
    auto const noted = [&](std::string const& radius) {
        Keys keys = wide;
        keys.front() = "circular_spline.inner_radius=" + radius;
        keys.emplace_back("wave_generator.radial_deformation=0.32");
        std::optional<Note> note = note_of(judge(builtin_scene(keys)), NoteCode::deformation);
        REQUIRE(note);
        return *note;
    };
    CHECK(noted("25.16").set == Keys{"wave_generator.radial_deformation=0.25"});
    CHECK_NOTHROW(solve(builtin_scene(wide)));
    // one that leaves little depth then does not stay
    CHECK(noted("25.35").set.size() == 2);
}

TEST_CASE("a land that is lost is won by what was computed, and by no larger deformation", "[judgement]")
{
    Keys keys{"wave_generator.radial_deformation=0.235", "circular_spline.inner_radius=25.02",
              "circular_spline.backlash_offset=0.06"};
    NumericalError const swept = failure(builtin_scene(keys));
    INFO(swept.what());
    CHECK(swept.code() == ErrorCode::no_land);
    CHECK_THAT(swept.remedy(), !ContainsSubstring("radial_deformation"));
    REQUIRE(swept.set().size() == 1);
    keys.push_back(swept.set().front());
    CHECK_NOTHROW(solve(builtin_scene(keys)));
}

TEST_CASE("undercut is never more than information", "[judgement]")
{
    Solution solution = solve(read_scene(HDCONJ_SOURCE_DIR "/data/scenes/type-50.toml"));
    for (double const lost : {0.0, 0.099, 0.101, 10.0}) {
        solution.flank_contact.used = 1;
        solution.flank_contact.lost = lost;
        auto const note = judgement::undercut(solution);
        REQUIRE(note.has_value() == (lost > 0.1));
        CHECK((!note || note->severity == Severity::information));
        CHECK((!note || note->advice == "write a flank with a larger radius there"));
    }
}

TEST_CASE("notes stand in text, JSON and HDF5", "[judgement]")
{
    TemporaryFolder const folder;
    Solution const solution = solve(printed({"wave_generator.radial_deformation=1.3"}));
    REQUIRE(solution.judgement.size() >= 1);
    Note const& first = solution.judgement.front();
    CHECK_THAT(summary_text(solution), ContainsSubstring(describe(solution.judgement)));
    auto const json = nlohmann::json::parse(summary_json(solution)).at("judgement");
    REQUIRE(json.size() == solution.judgement.size());
    CHECK(json.front().at("code") == "deformation");
    CHECK(json.front().at("severity") == "information");
    CHECK(json.front().at("figure") == first.figure);
    CHECK(json.front().at("limit") == 1.2);
    CHECK(json.front().at("advice") == first.advice);
    CHECK(json.front().at("set") == first.set);
}

TEST_CASE("tips that interfere at assembly are a warning with the tip circle to write", "[judgement]")
{
    auto const note = judgement::tip_interference(-0.06 * arcmin, 0.46e-3, 40.22925);
    REQUIRE(note);
    CHECK(note->code == NoteCode::backlash);
    CHECK(note->severity == Severity::warning);
    CHECK(note->place == "circular_spline.inner_radius");
    CHECK_THAT(note->cause, ContainsSubstring("by 0.46 um along the radius"));
    CHECK(note->set == Keys{"circular_spline.inner_radius=40.2293"});
}

TEST_CASE("notes: contacts that rounding does not tell apart write no other drive", "[judgement]")
{
    Scene const scene = builtin_scene({"wave_generator.radial_deformation=0.5"});
    Faults faults;
    profile::Profile const tooth = drive::given_tooth(scene, faults);
    wavegen::AnyWaveShape const shape = drive::wave_shape(scene, tooth, faults);
    PairGeometry const geometry = drive::pair_geometry(scene);
    auto const advised = [&](ErrorCode code) {
        NumericalError const error(code, "envelope", "profile piece 1", "cause");
        return judgement::with_likely_cause(error, {scene, geometry, tooth, shape});
    };
    CHECK(advised(ErrorCode::not_converged).set().empty());
    CHECK(advised(ErrorCode::not_converged).remedy().empty());
    CHECK_FALSE(advised(ErrorCode::no_outline).set().empty());
}

}  // namespace hdconj::test::judgement_cases
