// SPDX-License-Identifier: GPL-3.0-or-later
// The verb `inspect`: measured points of a part against its nominal outline.
#include "hdconj/inspect.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "arguments.hpp"
#include "hdconj/error.hpp"
#include "hdconj/inspect_files.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/result_files.hpp"
#include "hdconj/solve.hpp"
#include "run_verb.hpp"

namespace hdconj::cli {
namespace {

namespace fs = std::filesystem;

struct InspectArguments
{
    std::string points;  ///< file; empty: the first word is it
    std::string part = std::string(to_string(InspectedPart::flexspline));
    std::string registration = std::string(to_string(Registration::least_squares));
    std::optional<double> plane;
    double probe = 0;
    std::string output, deviations, pitch, picture, as_tooth;
};

/// Options with their values, whose words have been checked.
InspectOptions options_of(InspectArguments const& own)
{
    return {from_word<InspectedPart>(own.part).value(), own.plane, own.probe,
            from_word<Registration>(own.registration).value()};
}

/// A ball as large as the space between two teeth has touched no flank.
void check_probe(Scene const& scene, double probe, Faults& faults)
{
    double const largest = scene.drive.module;
    if (std::abs(probe) > largest)
        faults.push_back({"--probe", 0, std::to_string(probe),
                          "is larger than the module, and no such ball reaches a flank",
                          "write the radius of the ball in mm, such as --probe 0.1"});
}

/// A scene whose mean tooth solve refuses, or which makes no flank, helps nobody: it is not written.
/// @throws NumericalError with the cause, and how a tooth is measured better
void refuse_unsolvable(Inspection const& found, fs::path const& scene_file)
{
    auto const refuse = [&](ErrorCode code, std::string const& cause, std::string const& other) {
        throw NumericalError(code, "as-tooth", scene_file.string(),
                             "is not written, because the mean tooth of the measured points cannot be used: " + cause,
                             "measure more teeth, or more points on each flank up to its ends; or " + other);
    };
    std::string const look = "leave --as-tooth out and see by --picture which deviation it is";
    auto reading = measured_tooth_scene(found, scene_file);
    examine_geometry(reading);
    if (!reading.faults.empty())
        refuse(ErrorCode::no_outline, describe(reading.faults), look);
    Solution solution;
    try {
        solution = solve(reading.scene);
    } catch (NumericalError const& error) {
        refuse(error.code(), error.what(), look);
    }
    bool const flank = std::ranges::any_of(solution.circular_spline.pieces,
                                           [](OutlinePiece const& piece) { return piece.kind == "flank"; });
    if (!flank && !reading.scene.is_reverse())
        refuse(ErrorCode::no_outline,
               "its tip alone makes the tooth space, and no flank, so that contact and load have nothing to work on",
               "write a wave_generator.radial_deformation nearer to m (z_c - z_f)/2");
}

int run_inspect(CommonOptions const& given, InspectArguments const& asked)
{
    CommonOptions common = given;
    InspectArguments own = asked;
    if (own.points.empty())
        std::swap(own.points, common.scene);  // one word is the file of points: the drive is the built-in one
    if (own.points.empty())
        throw InputError(
            Fault{"POINTS", 0, "", "no file of measured points is given", "write hdconj inspect SCENE POINTS"});
    auto const reading = examine_drive(common);
    Faults faults = reading.faults;
    sort_by_place(faults);
    auto measured = examine_points(own.points);
    append(faults, measured.faults);
    check_probe(reading.scene, own.probe, faults);
    refuse(std::move(faults));
    Work<Inspection> work;
    work.inputs = inputs_of(common, reading.scene);
    append(work.inputs, input_of("POINTS", own.points));
    add_file(work, "hdf5", "--output", own.output,
             [](Inspection const& result, fs::path const& file) { write_hdf5(result, file); });
    add_file(work, "deviations", "--deviations", own.deviations, write_deviations);
    add_file(work, "pitch", "--pitch", own.pitch, write_pitch);
    add_file(work, "picture", "--picture", own.picture, write_chart, check_picture);
    add_file(work, "scene", "--as-tooth", own.as_tooth, write_measured_tooth);
    if (!own.as_tooth.empty()) {
        fs::path const points = measured_tooth_points(own.as_tooth);
        auto& [target, write] = work.outputs.back();
        target.members = {points};
        write = [write_both = std::move(write), points](Inspection& result) {
            Written written = write_both(result);
            written.push_back({"points", points, 0});
            return written;
        };
    }
    work.compute = [&](ProgressLine const& progress) {
        Inspection found = inspect_points(reading.scene, measured.measured, options_of(own), progress.stages());
        if (!own.as_tooth.empty())
            refuse_unsolvable(found, own.as_tooth);
        return found;
    };
    work.text = [](Inspection const& result, Written const& written) { return summary_text(result, written); };
    work.json = [](Inspection const& result, Written const& written) { return summary_json(result, written); };
    return run_verb(common, work);
}

constexpr char const* inspect_footer =
    "POINTS is a CSV file whose first line names the columns x, y and, where they are known, z, tooth and flank, such\n"
    "as\n"
    "  x [mm], y [mm], z [mm], tooth, flank\n"
    "  0.1203, 25.0871, 0, 1, right\n"
    "or a DXF file (ending .dxf), of which the points and the vertices of polylines are taken.\n"
    "The axis of the part is at (0, 0); the middle of tooth 1 (of a space of the circular spline) is on +y, teeth are\n"
    "counted clockwise. The flexspline is measured before assembly, when it is round. With one file name, that is\n"
    "POINTS, and the drive is the built-in one.\n"
    "Registrations: datum takes the points as they are; turn turns them about the axis; least-squares turns and "
    "shifts\n"
    "them, with the least sum of squared deviations; minimum-zone with the least largest deviation.\n"
    "A deviation is positive outside the material. A ball's centre is --probe outside the material; write a negative\n"
    "radius where centres lie inside it, as after a wrong compensation.\n"
    "Examples:\n"
    "  hdconj inspect drive.toml points.csv\n"
    "  hdconj inspect drive.toml centres.csv --probe 0.1 --register turn --json\n"
    "  hdconj inspect drive.toml points.csv --as-tooth cut.toml --picture chart.svg\n"
    "  hdconj inspect drive.toml ring.csv --part circular-spline --deviations deviations.csv";

}  // namespace

void add_inspect(CLI::App& program, CommonOptions& common)
{
    auto [verb, own] =
        add_verb(program, common, "inspect", "measured points of a part against its nominal outline", run_inspect);
    add_scene_options(verb, common);
    add_name(verb, "POINTS", own.points, "file of measured points, CSV or DXF");
    add_option(verb, "--part", own.part, "that was measured: flexspline, circular-spline [flexspline]", "WORD",
               one_of<InspectedPart>());
    add_option(verb, "--plane", own.plane, "height in mm, 0 in the middle of the bearing [all of the file]", "Z",
               finite_number("write a height in mm such as --plane 0"));
    add_option(verb, "--probe", own.probe, "radius in mm of the ball whose centres are given; negative: inside [0]",
               "R", finite_number("write a radius in mm such as --probe 0.1"));
    add_option(verb, "--register", own.registration, "datum, turn, least-squares, minimum-zone [least-squares]", "WORD",
               one_of<Registration>());
    add_name(verb, "--deviations", own.deviations, "every point with its deviation", "FILE.csv");
    add_name(verb, "--pitch", own.pitch, "place of each tooth along the pitch circle, for [errors] of a scene",
             "FILE.csv");
    add_name(verb, "-o,--output", own.output, "result file, HDF5 [none]", "FILE.h5");
    add_name(verb, "--picture", own.picture, "chart of one page, needs gnuplot", "FILE.svg|FILE.png");
    add_name(verb, "--as-tooth", own.as_tooth, "the scene with the mean measured tooth; its points in NAME-tooth.csv",
             "NAME.toml");
    verb.footer(inspect_footer);
}

}  // namespace hdconj::cli
