// SPDX-License-Identifier: GPL-3.0-or-later
// The verb `design`: a whole scene from a few wishes.
#include "hdconj/design.hpp"

#include <cmath>
#include <filesystem>
#include <iostream>
#include <optional>

#include "arguments.hpp"
#include "hdconj/design_files.hpp"
#include "hdconj/error.hpp"
#include "hdconj/read_scene.hpp"
#include "run_verb.hpp"

namespace hdconj::cli {
namespace {

namespace fs = std::filesystem;

struct DesignArguments
{
    DesignWishes wishes;
    double diameter = NAN, module = NAN, torque = NAN;                 ///< NaN: not given
    double fatigue = NAN, youngs_modulus = NAN, poissons_ratio = NAN;  ///< NaN: not given
    std::string output;                                                ///< the scene; empty: none is written
    bool force = false;
};

std::optional<double> given(double value, double unit = 1)
{
    return std::isnan(value) ? std::nullopt : std::optional(value * unit);
}

DesignWishes wishes_of(DesignArguments const& own)
{
    DesignWishes wishes = own.wishes;
    wishes.diameter = given(own.diameter);
    wishes.module = given(own.module);
    wishes.torque = given(own.torque, newton_metre);
    wishes.fatigue = given(own.fatigue);
    wishes.youngs_modulus = given(own.youngs_modulus);
    wishes.poissons_ratio = given(own.poissons_ratio);
    if (!own.output.empty())
        wishes.name = file_name(fs::path(own.output).stem().string());
    return wishes;
}

int run_design(CommonOptions const& common, DesignArguments const& own)
{
    DesignWishes const wishes = wishes_of(own);
    Faults faults = check_design(wishes);
    if (!own.output.empty())
        append(faults, occupied(own.output, own.force));
    refuse(faults);
    Work<Design> work;
    add_file(work, "scene", "--output", own.output,
             [](Design const& design, fs::path const& file) { file::write_text_atomically(file, scene_text(design)); });
    work.compute = [&](ProgressLine const& progress) {
        Design design = design_drive(wishes, [&](std::string const& what) { progress.say(what); });
        Scene const type_50 = builtin_scene();
        if (is_like(design, type_50))
            design.differences = differences(design, type_50);
        return design;
    };
    work.text = [&](Design const& design, Written const&) {
        for (std::string const& remark : design.remarks)
            std::cerr << "note: " << remark << '\n';
        return summary_text(design);
    };
    work.json = [](Design const& design, Written const& written) { return summary_json(design, written); };
    work.wrote = [](Design const&, Written const& written) {
        std::vector<std::string> said;
        for (auto const& each : written)
            said.push_back(each.file.string() + "; next: hdconj check " + each.file.string());
        return said;
    };
    return run_verb(common, work);
}

void add_wishes(CLI::App& verb, DesignArguments& own)
{
    DesignWishes& wishes = own.wishes;
    auto const number = [&](char const* name, double& value, char const* meaning, char const* type,
                            char const* example) {
        add_option(verb, name, value, meaning, type, finite_number(std::string("write a number such as ") + example));
    };
    number("--ratio", wishes.ratio, "i = z_f/(z_c - z_f), circular spline held, a whole number from 30 to 320", "I",
           "100");
    verb.get_option("--ratio")->required();
    number("--diameter", own.diameter, "pitch diameter of the flexspline, m z_f, in mm", "MM", "50");
    number("--module", own.module, "in mm [the standard one nearest to the diameter]", "MM", "0.25");
    number("--length-ratio", wishes.length_ratio, "length of the cup over the pitch diameter, 0.2 to 1 [0.25]", "L/D",
           "0.25");
    number("--torque", own.torque, "rated torque on the circular spline in N m, for which the wall is chosen [none]",
           "NM", "28");
    verb.add_option("--family", wishes.family, "of the flexspline's tooth [double-circular-arc]")->type_name("WORD");
    verb.add_option("--material", wishes.material,
                    "of the flexspline: 30CrMnSiA, 40CrNiMoA, 42CrMo4, 34CrNiMo6, 30CrNiMo8 or your own [30CrMnSiA]")
        ->type_name("WORD");
    number("--fatigue", own.fatigue, "its fatigue strength in alternating bending, in MPa [of the material]", "MPA",
           "550");
    number("--youngs-modulus", own.youngs_modulus, "its modulus of elasticity in MPa [of the material]", "MPA",
           "206000");
    number("--poissons-ratio", own.poissons_ratio, "its Poisson's ratio [of the material]", "NU", "0.3");
    number("--land", wishes.land, "least tip land in modules [0.4]", "M", "0.4");
    number("--clearance", wishes.clearance,
           "least side clearance of each flank in mm; with --torque more where the cone needs it [0]", "MM", "0.02");
    number("--safety", wishes.safety,
           "least fatigue strength over largest stress of the cup; without --torque of its bent ring alone [1.2]", "S",
           "1.2");
}

}  // namespace

Faults occupied(std::string const& file, bool force)
{
    std::error_code ignored;
    if (fs::is_directory(file, ignored))
        return {{file, 0, "", "this is a folder", "name a file in it"}};
    if (!force && fs::exists(fs::symlink_status(file, ignored)))
        return {{file, 0, "", "this file is there already", "use --force to write over it"}};
    return {};
}

void add_design(CLI::App& program, CommonOptions& common)
{
    auto [verb, own] = add_verb(program, common, "design", "a whole scene from a few wishes", run_design);
    verb.preparse_callback([&common](std::size_t) { common.subject = "the wishes"; });
    add_wishes(verb, own);
    add_name(verb, "-o,--output", own.output, "the scene to write, TOML [none]", "FILE");
    verb.add_flag("--force", own.force, "write over a file that is there");
    verb.add_flag("--json", common.json, "one JSON object on standard output");
    verb.add_flag("-q,--quiet", common.quiet, "no summary and no progress");
    verb.footer(
        "Dimensions follow the thesis' rules. Radial deformation and tip circle are searched by `solve`.\n"
        "With a torque the wall is searched by `load`, which takes some seconds for each.\n"
        "The table says of each dimension its range, rule and source.\n"
        "Example:\n"
        "  hdconj design --ratio 100 --diameter 50 --length-ratio 0.25 --torque 28 -o drive.toml");
}

}  // namespace hdconj::cli
