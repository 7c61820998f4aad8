// SPDX-License-Identifier: GPL-3.0-or-later
// The verb `wedm`: coordinate files for cutting by wire.
#include "hdconj/wedm.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <optional>

#include "arguments.hpp"
#include "hdconj/error.hpp"
#include "hdconj/load.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/result_files.hpp"
#include "hdconj/scene/reading.hpp"
#include "hdconj/solve.hpp"
#include "hdconj/units.hpp"
#include "hdconj/wire_files.hpp"
#include "run_verb.hpp"

namespace hdconj::cli {
namespace {

namespace fs = std::filesystem;

struct WireArguments
{
    std::string part;  ///< empty: as the scene says
    std::optional<double> tilt_deg;
    std::string output;                 ///< folder; empty: named after the scene file
    std::string from;                   ///< result file; empty: the scene is solved
    std::vector<std::string> dialects;  ///< empty: as the scene says
    std::optional<std::string> decimals;
    std::string picture;
};

/// A scene with [wedm], and its solution where that was stored.
struct WireInput
{
    Scene scene;
    std::optional<Solution> solved;
    std::optional<StoredOutline> of_case;  ///< another ring than the scene's, which is solved

    /// The flexspline is cut in two set-ups.
    [[nodiscard]] bool cuts_flexspline() const { return scene.wedm->part == WirePart::flexspline; }
};

/// What the wire does, and the files that say so.
struct WireCut
{
    WireSetUps programs;
    std::vector<WireFile> files;
};

/// @p common with the options that stand for keys of the scene.
CommonOptions with_keys(CommonOptions const& common, WireArguments const& own)
{
    CommonOptions all = common;
    if (!own.part.empty())
        all.overrides.push_back("wedm.part=" + own.part);
    if (own.tilt_deg)
        all.overrides.push_back(fmt::format("tilt.angle_deg={}", *own.tilt_deg));
    if (own.decimals)
        all.overrides.push_back("wedm.decimals=" + *own.decimals);
    return all;
}

/// The scene of a result file is the file's own; --set may change what the wire is to do.
WireInput stored(CommonOptions const& common, WireArguments const& own)
{
    auto const refuse_from = [&](std::string const& reason, std::string const& remedy) {
        throw InputError(Fault{"--from", 0, own.from, reason, remedy});
    };
    if (!common.scene.empty())
        refuse_from("a result holds its own scene, and " + scene_name(common) + " is given too",
                    "leave one of them out; --set changes keys of the table [wedm]");
    if (own.tilt_deg)
        refuse_from("the stored outline has the tilt that it was solved with, and --tilt is given too",
                    "leave one of them out");
    for (auto const& given : common.overrides) {
        std::string_view key = given;
        if (key.starts_with('!'))
            key.remove_prefix(1);
        key = key.substr(0, key.find('='));
        if (key != "wedm" && !key.starts_with("wedm."))
            refuse_from("the stored outline was solved with another scene than one with --set " + given,
                        "change keys of the table [wedm] only, or leave --from out");
    }
    auto result = read_outline(own.from);
    auto reading = examine_stored_scene(result, own.from, common.overrides);
    refuse(std::move(reading.faults));
    if (reading.scene.wedm && reading.scene.wedm->part == WirePart::flexspline)
        reading.scene.tilt.reset();  // of the circular spline: nothing of the flexspline depends on it
    if (result.verb.empty())
        return {std::move(reading.scene), std::move(result.solution), {}};
    return {std::move(reading.scene), {}, std::move(result)};
}

WireInput input_for(CommonOptions const& common, WireArguments const& own)
{
    CommonOptions const all = with_keys(common, own);
    WireInput input = own.from.empty() ? WireInput{load_drive(all), {}, {}} : stored(all, own);
    Faults faults = check_wedm(input.scene);
    if (faults.empty() && own.dialects.empty())
        faults = check_named_dialects(input.scene);
    refuse(std::move(faults));
    return input;
}

/// What @p from found of the ring of the scene, which the wire cuts: that its teeth interfere; else empty.
std::string found_interference(StoredOutline const& stored, Scene const& scene, std::string const& from)
{
    if (scene.wedm->part == WirePart::flexspline || scene.circular_spline.automatic_backlash)
        return {};
    ToothSurface const surface = scene.slices ? scene.slices->surface : ToothSurface::tilted;
    double const tilt = scene.tilt ? scene.tilt->angle : 0;
    auto const found = std::ranges::find_if(stored.cases, [&](StoredCase const& each) {
        return each.interferes && each.surface == to_string(surface) && each.tilt == tilt &&
               (tilt == 0 || each.kind == to_string(scene.tilt->kind));
    });
    if (found == stored.cases.end())
        return {};
    auto const up = [](double length) { return std::ceil(length * 1e6) / 1e6; };  // to the digits that are printed
    bool const is_told = found->flank_clearance && *found->flank_clearance < 0;
    return fmt::format(
        "circular_spline.backlash_offset = {:g}: {} in {} found that teeth enter the flanks{}; write "
        "circular_spline.backlash_offset = {:.6f} and circular_spline.inner_radius = {:.6f}",
        scene.circular_spline.backlash_offset, stored.verb, from,
        is_told ? fmt::format(" by {:.3g} um, most at z = {:.3f} mm", -*found->flank_clearance * per_um, found->flank_z)
                : "",
        up(found->side_clearance), up(found->tip_radius));
}

void say_warning(std::string const& warning, bool quiet)
{
    if (!quiet)
        std::cerr << "hdconj: warning: " << warning << '\n';
}

/// The set-ups of the part; those of the circular spline from its stored solution, where there is one.
WireSetUps programs_of(WireInput const& input, StageObserver const& on_stage)
{
    if (input.cuts_flexspline())
        return wire_set_ups(input.scene, on_stage);
    if (input.solved)
        return {wire_program(input.scene, *input.solved)};
    return wire_set_ups(input.scene, on_stage);
}

/// A ring of the file @p from that is not the one that is cut is a warning, and said on standard error.
void tell_other_ring(WireInput const& input, std::string const& from, bool quiet, WireSetUps& programs)
{
    if (!input.of_case || input.cuts_flexspline())
        return;
    StoredOutline const& stored = *input.of_case;
    std::optional<Coning> cone;
    if (stored.solution.error.cup != 0)  // NaN of a cup whose error was not asked for
        cone = loaded_scene(input.scene).coning;
    std::string const told =
        other_ring(stored.solution.circular_spline, stored.side_clearance, cone, input.scene, programs.front());
    if (told.empty())
        return;
    programs.front().warnings.push_back(fmt::format(
        "{} holds the ring of a case of {}; the wire cuts the ring of the stored scene, and that case has {}", from,
        stored.verb, told));
    say_warning(programs.front().warnings.back(), quiet);
}

/// Says on standard error that the teeth of the ring interfere, where a result or the scene tells it, and enters what a
/// result tells in the place of what the scene alone says.
void tell_interference(WireInput const& input, std::string const& from, bool quiet, WireSetUps& programs)
{
    std::string const missing = missing_side_clearance(input.scene);
    std::string const found = input.of_case ? found_interference(*input.of_case, input.scene, from) : std::string();
    if (!found.empty()) {
        std::erase(programs.front().warnings, missing);
        programs.front().warnings.push_back(found);
    }
    if (std::string const& told = found.empty() ? missing : found; !told.empty())
        say_warning(told, quiet);
}

void add_files(Work<WireCut>& work, WireArguments const& own, fs::path const& folder,
               std::vector<std::string> const& dialects, std::size_t set_ups)
{
    std::string const place = own.dialects.empty() ? "wedm.dialects" : "--dialect";
    OutputTarget target{"wire files", "--output", folder, [=] { check_wire_files(folder, dialects, place); }};
    target.is_folder = true;
    work.outputs.push_back({target, [=](WireCut& cut) {
                                cut.files = write_wire_files(cut.programs, folder, dialects);
                                return Written{};
                            }});
    if (own.picture.empty())
        return;
    fs::path const picture = own.picture;
    auto const names = wire_picture_names(picture, set_ups);
    target = {"picture", "--picture", picture, [=] { check_wire_pictures(picture, set_ups); }, names.rings};
    append(target.members, {names.tooth, names.residual});
    work.outputs.push_back({target, [=](WireCut const& cut) { return write_wire_pictures(cut.programs, picture); }});
}

int run_wedm(CommonOptions const& common, WireArguments const& own)
{
    WireInput const input = input_for(common, own);
    auto const dialects = own.dialects.empty() ? named_dialects(input.scene) : own.dialects;
    fs::path const folder =
        output_name(common, own.output, input.scene, input.cuts_flexspline() ? "-flexspline-wedm" : "-wedm");
    Work<WireCut> work;
    work.inputs = inputs_of(common, input.scene);
    append(work.inputs, input_of("--from", own.from));
    add_files(work, own, folder, dialects, input.cuts_flexspline() ? 2 : 1);
    work.compute = [&](ProgressLine const& progress) {
        WireCut cut{programs_of(input, progress.stages()), {}};
        progress.clear();
        tell_other_ring(input, own.from, common.quiet, cut.programs);
        tell_interference(input, own.from, common.quiet, cut.programs);
        settle_unfit_dialects(cut.programs, input.scene, dialects, input.solved ? &*input.solved : nullptr);
        return cut;
    };
    work.text = [&](WireCut const& cut, Written const&) {
        return summary_text(cut.programs, cut.files) + "\nwritten into " + folder.string() + '\n';
    };
    work.json = [&](WireCut const& cut, Written const& pictures) {
        return summary_json(cut.programs, cut.files, folder, pictures);
    };
    work.wrote = [&](WireCut const& cut, Written const& pictures) {
        std::vector<std::string> names = names_of(pictures);
        if (common.json)
            names.insert(names.begin(), fmt::format("{} files into {}", cut.files.size(), folder.string()));
        return names;
    };
    work.judgement = [](WireCut const& cut) { return cut.programs.front().judgement; };
    return run_verb(common, work);
}

std::string dialects_text()
{
    std::string text = "Dialects:\n";
    for (auto const& dialect : wire_dialects())
        text += fmt::format(
            "  {:<12}{}{}\n", dialect.name, dialect.meaning,
            dialect.verified() ? fmt::format(" [read by: {}]", dialect.verified_by) : " [not verified on hardware]");
    return text;
}

}  // namespace

void add_wedm(CLI::App& program, CommonOptions& common)
{
    auto [verb, own] =
        add_verb(program, common, "wedm",
                 "coordinate files for cutting the circular spline, or the flexspline, by wire", run_wedm);
    add_scene_options(verb, common);
    add_strict(verb, common);
    add_option(verb, "--part", own.part,
               "circular-spline or flexspline, key wedm.part [the scene's, or circular-spline]", "WORD",
               one_of<WirePart>());
    add_option(verb, "--tilt", own.tilt_deg,
               "tilt of the circular spline's teeth, key tilt.angle_deg [the scene's, or 0]", "DEG",
               angle("an angle in degrees such as 0.2"));
    add_name(verb, "-o,--output", own.output, "folder to make [the scene file's name and -wedm, in this folder]",
             "DIR");
    add_name(verb, "--from", own.from,
             "take scene and outline from a result file; of contact, load or run: only the scene", "FILE.h5");
    add_list(verb, "--dialect", own.dialects, "files to write, see below [the scene's, or all that fit]", "NAME,...");
    add_option(verb, "--decimals", own.decimals, "of coordinates in mm, key wedm.decimals [the scene's, or 4]", "N",
               finite_number("write a whole number such as 4"));
    add_name(verb, "--picture", own.picture, "drawings NAME-tooth, NAME-ring, NAME-residual; needs gnuplot",
             "NAME.svg|NAME.png");
    verb.footer(
        dialects_text() +
        "The wire's diameter and spark gap stand in the scene, table [wedm]; there is no default for them.\n"
        "Nothing is written unless every file, read back, gives both faces again to one unit of its last digit.\n"
        "Examples:\n"
        "  hdconj wedm drive.toml --tilt 0.2 -o cut --picture cut.svg\n"
        "  hdconj wedm --tilt 0.2 --dialect dxf,csv --decimals 5 -o cut\n"
        "  hdconj wedm drive.toml --part flexspline --set wedm.overlap=0.05\n"
        "  hdconj wedm --from drive.h5 --set wedm.wire_diameter=0.07");
}

}  // namespace hdconj::cli
