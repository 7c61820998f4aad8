// SPDX-License-Identifier: GPL-3.0-or-later
#include "verbs.hpp"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/unique_ptr.h>
#include <nanobind/stl/variant.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <variant>

#include "call.hpp"
#include "figures.hpp"
#include "hdconj/accuracy_files.hpp"
#include "hdconj/contact_files.hpp"
#include "hdconj/design_files.hpp"
#include "hdconj/file/atomic_file.hpp"
#include "hdconj/inspect_files.hpp"
#include "hdconj/measured.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/report.hpp"
#include "hdconj/result_files.hpp"
#include "hdconj/running_files.hpp"
#include "hdconj/solve.hpp"
#include "hdconj/units.hpp"
#include "layout.hpp"
#include "report/html/stored_drive.hpp"
#include "result_of.hpp"
#include "scene.hpp"
#include "stored.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace hdconj::python {
namespace {

using ResultPointer = std::unique_ptr<Result>;
using Words = std::vector<std::string>;

/// The value of @p word; where it is none, a fault of @p argument.
template <Worded Enumeration>
std::optional<Enumeration> value_of(std::string const& word, char const* argument, Faults& faults)
{
    auto const value = from_word<Enumeration>(word);
    if (!value) {
        std::string known;
        for (auto const each : words_of<Enumeration>)
            known += (known.empty() ? "" : ", ") + std::string(each);
        faults.push_back({argument, 0, word, "is no word that this argument takes", "write one of " + known});
    }
    return value;
}

template <Worded Enumeration>
std::vector<Enumeration> values_of(Words const& words, char const* argument, Faults& faults)
{
    std::vector<Enumeration> values;
    for (auto const& word : words)
        if (auto const value = value_of<Enumeration>(word, argument, faults))
            values.push_back(*value);
    return values;
}

/// Tilts, surfaces and kinds, which contact and load share.
void enter_cases(auto& options, std::vector<double> const& tilts_deg, Words const& surfaces, Words const& kinds)
{
    Faults faults;
    for (double const tilt : tilts_deg)
        options.tilts.push_back(tilt * deg);
    options.surfaces = values_of<ToothSurface>(surfaces, "surfaces", faults);
    options.kinds = values_of<TiltKind>(kinds, "kinds", faults);
    refuse(faults);
}

ResultPointer run_solve(SceneHandle const& handle, bool advice, nb::handle observer)
{
    Scene const& scene = handle.sound();
    if (scene.wants_neutral_curve())
        throw InputError(Fault{"wave_generator.family", 0, scene.wave_generator.shape.family,
                               "the neutral curve is not known yet", "call find_neutral_curve(), which finds it"});
    return run(observer, [&](Observer const& told) {
        Solution solution = solve(scene, told.stages());
        if (advice)
            try_advice(solution);
        return result_of(std::move(solution));
    });
}

ResultPointer run_find_neutral_curve(SceneHandle const& handle, nb::handle observer)
{
    Scene const& scene = handle.sound();
    return run(observer, [&](Observer const& told) { return result_of(find_neutral_curve(scene, told.stages())); });
}

ResultPointer run_contact(SceneHandle const& handle, std::vector<double> const& tilts_deg, Words const& surfaces,
                          Words const& kinds, std::optional<std::pair<double, double>> const& best_deg, int revolution,
                          bool errors, nb::handle observer)
{
    Scene const& scene = handle.sound();
    ContactOptions options;
    enter_cases(options, tilts_deg, surfaces, kinds);
    options.revolution = revolution;
    options.errors = errors;
    if (best_deg) {
        options.best = true;
        options.best_from = best_deg->first * deg;
        options.best_to = best_deg->second * deg;
    }
    refuse(check_contact(scene, options));
    return run(observer, [&](Observer const& told) {
        return result_of(study_contact(scene, options, told.stages(), told.shares()));
    });
}

ResultPointer run_load(SceneHandle const& handle, std::optional<double> torque, std::optional<int> points,
                       std::vector<double> const& tilts_deg, Words const& surfaces, Words const& kinds, bool curve,
                       bool errors, Result const* measured, nb::handle observer)
{
    Scene const& scene = handle.sound();
    LoadOptions options;
    enter_cases(options, tilts_deg, surfaces, kinds);
    if (torque)
        options.torque = *torque * newton_metre;
    options.points = points;
    options.curve = curve;
    options.errors = errors;
    refuse(check_load(scene, options));
    std::optional<Measurement> measurement;
    if (measured != nullptr)
        measurement = dynamic_cast<ResultOf<Measurement> const&>(*measured).value();
    return run(observer, [&](Observer const& told) {
        return result_of(LoadedDrive{study_load(scene, options, told.stages(), told.shares()), std::move(measurement)});
    });
}

ResultPointer run_run(SceneHandle const& handle, std::optional<double> torque, std::optional<int> positions,
                      bool errors, nb::handle observer)
{
    Scene const& scene = handle.sound();
    RunOptions options;
    if (torque)
        options.torque = *torque * newton_metre;
    options.positions = positions;
    options.errors = errors;
    refuse(check_run(scene, options));
    return run(observer, [&](Observer const& told) {
        return result_of(study_run(scene, options, told.stages(), told.shares()));
    });
}

ResultPointer run_wedm(SceneHandle const& handle, std::string const& folder, Words const& asked, nb::handle observer)
{
    Scene const& scene = handle.sound();
    refuse(check_wedm(scene));
    Words const dialects = asked.empty() ? named_dialects(scene) : asked;
    std::string const place = asked.empty() ? "wedm.dialects" : "dialects";
    if (folder.empty())
        refuse(check_dialects(dialects, place));
    else
        check_wire_files(folder, dialects, place);
    return run(observer, [&](Observer const& told) {
        WireCut cut{wire_set_ups(scene, told.stages()), {}, folder};
        settle_unfit_dialects(cut.programs, scene, dialects);
        if (!folder.empty())
            cut.files = write_wire_files(cut.programs, folder, dialects);
        return result_of(std::move(cut));
    });
}

ResultPointer run_accuracy(SceneHandle const& handle, Words const& studies, int sample, int repeats, bool quick,
                           nb::handle observer)
{
    Scene const& scene = handle.sound();
    AccuracyOptions options;
    options.studies = studies;
    options.sample = sample;
    options.repeats = repeats;
    options.quick = quick;
    refuse(check_studies(options));
    refuse(check_accuracy(scene, options));
    return run(observer, [&](Observer const& told) {
        return result_of(StoredAccuracy{measure_accuracy(scene, options, told.shares()), this_program()});
    });
}

ResultPointer run_inspect(SceneHandle const& handle, std::string const& points, std::string const& part,
                          std::optional<double> plane, double probe, std::string const& registration,
                          nb::handle observer)
{
    Faults faults = handle.faults();
    auto measured = examine_points(points);
    faults.insert(faults.end(), measured.faults.begin(), measured.faults.end());
    auto const which = value_of<InspectedPart>(part, "part", faults);
    auto const how = value_of<Registration>(registration, "register", faults);
    refuse(faults);
    InspectOptions const options{*which, plane, probe, *how};
    return run(observer, [&](Observer const& told) {
        return result_of(inspect_points(handle.as_read(), measured.measured, options, told.stages()));
    });
}

ResultPointer read_measured(SceneHandle const& handle, std::string const& file, std::optional<double> torque_constant,
                            std::optional<double> counts_per_turn, std::optional<double> ratio,
                            std::optional<double> efficiency, std::string const& output_member)
{
    auto const& drive = handle.sound().drive;
    Faults faults;
    auto const member = value_of<OutputMember>(output_member, "output_member", faults);
    auto reading =
        examine_measurement(file, {torque_constant, counts_per_turn, ratio, efficiency},
                            member.value_or(OutputMember::cup), drive.flexspline_teeth, drive.circular_spline_teeth);
    faults.insert(faults.end(), reading.faults.begin(), reading.faults.end());
    refuse(faults);
    return result_of(std::move(*reading.measurement));
}

/// Sine and cosine of the turn, and place, of each tooth in each plane.
std::vector<double> poses_of_teeth(SceneHandle const& handle, std::vector<double> const& z, double pitches)
{
    std::vector<double> rows;
    for (Pose const& pose : flexspline_poses(handle.sound(), z, pitches))
        rows.insert(rows.end(), {pose.sine, pose.cosine, pose.origin.x(), pose.origin.y()});
    return rows;
}

/// A scene, or a result of that name.
using ReportSource = std::variant<SceneHandle const*, std::pair<std::string, nb::object>>;

ReportedDrive drive_of(std::string const& name, nb::object const& result)
{
    try {
        if (nb::isinstance<nb::str>(result))  // why there is none
            throw io::layout::Misfit(nb::cast<std::string>(result));
        return report::drive_from(PythonGroup(result), name);
    } catch (io::layout::Misfit const& misfit) {
        throw InputError(Fault{name, 0, "", std::string("is no result that a report can show: ") + misfit.what(),
                               "make it anew by hdconj.solve, contact, load or run"});
    }
}

/// A scene to compute, or a drive that is read.
using ListedDrive = std::variant<Scene const*, ReportedDrive>;

Scene const& scene_of(ListedDrive const& drive)
{
    auto const* const scene = std::get_if<Scene const*>(&drive);
    return scene != nullptr ? **scene : std::get<ReportedDrive>(drive).solution.scene;
}

/// With the faults of all.
std::vector<ListedDrive> drives_to_report(std::vector<ReportSource> const& sources, Faults& faults)
{
    std::vector<ListedDrive> drives;
    for (ReportSource const& source : sources) {
        try {
            if (auto const* const handle = std::get_if<SceneHandle const*>(&source))
                drives.emplace_back(&(*handle)->sound());
            else
                drives.emplace_back(std::apply(drive_of, std::get<1>(source)));
            for (Fault const& fault : check_report(scene_of(drives.back())))
                faults.push_back(fault);
        } catch (InputError const& error) {
            faults.insert(faults.end(), error.faults().begin(), error.faults().end());
        }
    }
    return drives;
}

/// Writes the page. @return what it leaves out though it was asked for, a line each
Words run_report(std::vector<ReportSource> const& sources, std::string const& file, Words const& parts,
                 std::vector<double> const& tilts_deg, int revolution, bool curve, nb::handle observer)
{
    Faults faults;
    if (sources.empty())
        faults.push_back({"scenes", 0, "", "an empty list: a page shows at least one drive",
                          "give a scene, a result or a list of these, or None for the built-in drive"});
    auto const listed = drives_to_report(sources, faults);
    ReportOptions options;
    options.parts = values_of<ReportPart>(parts, "parts", faults);
    for (double const tilt : tilts_deg)
        options.contact.tilts.push_back(tilt * deg);
    options.contact.revolution = revolution;
    options.load.curve = curve;
    auto const is_scene = [](ReportSource const& source) { return std::holds_alternative<SceneHandle const*>(source); };
    bool const computes = sources.empty() || std::ranges::any_of(sources, is_scene);
    for (Fault const& fault : computes ? check_report(options) : check_without_scene(options))
        faults.push_back(fault);
    refuse(faults);
    file::check_target(file);
    return run(observer, [&](Observer const& told) {
        Report const report = report_drives(
            listed, [](ListedDrive const& each) { return scene_of(each).drive.name; },
            [&](ListedDrive const& each) {
                auto const* const scene = std::get_if<Scene const*>(&each);
                return scene != nullptr ? report_drive(**scene, options, told.stages(), told.shares())
                                        : complete_drive(std::get<ReportedDrive>(each), options, told.stages());
            });
        file::write_text_atomically(file, report_page(report));
        return missing_of(report);
    });
}

nb::tuple run_design(DesignWishes const& wishes, nb::handle observer)
{
    refuse(check_design(wishes));
    std::string scene;
    auto result = run(observer, [&](Observer const& told) {
        Design made = design_drive(wishes, [&](std::string const& what) { told.tell(what, std::nullopt); });
        Scene const type_50 = builtin_scene();
        if (is_like(made, type_50))
            made.differences = differences(made, type_50);
        scene = scene_text(made);
        return result_of(std::move(made));
    });
    return nb::make_tuple(text_of(scene), std::move(result));
}

void add_wishes(nb::module_& module)
{
    nb::class_<DesignWishes>(module, "DesignWishes")
        .def(nb::init<>())
        .def_rw("ratio", &DesignWishes::ratio)
        .def_rw("diameter", &DesignWishes::diameter, nb::none())
        .def_rw("module", &DesignWishes::module, nb::none())
        .def_rw("length_ratio", &DesignWishes::length_ratio)
        .def_prop_rw(
            "torque", [](DesignWishes const& wishes) { return wishes.torque; },
            [](DesignWishes& wishes, std::optional<double> torque_nm) {
                wishes.torque = torque_nm ? std::optional(*torque_nm * newton_metre) : std::nullopt;
            },
            nb::none())
        .def_rw("family", &DesignWishes::family)
        .def_rw("material", &DesignWishes::material)
        .def_rw("fatigue", &DesignWishes::fatigue, nb::none())
        .def_rw("youngs_modulus", &DesignWishes::youngs_modulus, nb::none())
        .def_rw("poissons_ratio", &DesignWishes::poissons_ratio, nb::none())
        .def_rw("land", &DesignWishes::land)
        .def_rw("clearance", &DesignWishes::clearance)
        .def_rw("safety", &DesignWishes::safety)
        .def_rw("name", &DesignWishes::name);
    module.def("design", run_design, "wishes"_a, "observer"_a.none());
}

}  // namespace

void add_verbs(nb::module_& module)
{
    nb::class_<Result>(module, "Result")
        .def("layout", [](nb::handle_t<Result> self) { return layout_of(nb::cast<Result const&>(self), self); })
        .def("figures", figures_of)
        .def("json", [](Result const& result) { return text_of(result.json()); })
        .def("text", [](Result const& result) { return text_of(result.text()); })
        .def_prop_ro("missing", &Result::missing)
        .def_ro("seconds", &Result::seconds);
    module.def("solve", run_solve, "scene"_a, "advice"_a, "observer"_a.none());
    module.def("find_neutral_curve", run_find_neutral_curve, "scene"_a, "observer"_a.none());
    module.def("contact", run_contact, "scene"_a, "tilts_deg"_a, "surfaces"_a, "kinds"_a, "best_deg"_a.none(),
               "revolution"_a, "errors"_a, "observer"_a.none());
    module.def("load", run_load, "scene"_a, "torque"_a.none(), "points"_a.none(), "tilts_deg"_a, "surfaces"_a,
               "kinds"_a, "curve"_a, "errors"_a, "measured"_a.none(), "observer"_a.none());
    module.def("run", run_run, "scene"_a, "torque"_a.none(), "positions"_a.none(), "errors"_a, "observer"_a.none());
    module.def("wedm", run_wedm, "scene"_a, "folder"_a, "dialects"_a, "observer"_a.none());
    module.def("accuracy", run_accuracy, "scene"_a, "studies"_a, "sample"_a, "repeats"_a, "quick"_a,
               "observer"_a.none());
    module.def("inspect", run_inspect, "scene"_a, "points"_a, "part"_a, "plane"_a.none(), "probe"_a, "register"_a,
               "observer"_a.none());
    module.def(
        "is_result_file", [](std::string const& file) { return is_result_file(file); }, "file"_a);
    module.def("report", run_report, "sources"_a, "file"_a, "parts"_a, "tilts_deg"_a, "revolution"_a, "curve"_a,
               "observer"_a.none());
    module.def("read_measured", read_measured, "scene"_a, "file"_a, "torque_constant"_a.none(),
               "counts_per_turn"_a.none(), "ratio"_a.none(), "efficiency"_a.none(), "output_member"_a);
    module.def("flexspline_poses", poses_of_teeth, "scene"_a, "z"_a, "pitches"_a);
    add_wishes(module);
}

}  // namespace hdconj::python
