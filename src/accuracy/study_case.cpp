// SPDX-License-Identifier: GPL-3.0-or-later
#include "study_case.hpp"

#include <utility>

#include "designs.hpp"
#include "hdconj/base/parallel.hpp"
#include "hdconj/check.hpp"
#include "hdconj/error.hpp"
#include "hdconj/solve.hpp"

namespace hdconj::accuracy {

Scene plain(Scene const& scene, std::vector<std::string>& notes)
{
    Scene plain = scene;
    auto const leave_out = [&](bool there, char const* what) {
        if (there)
            notes.push_back(
                std::string(what) +
                " left out: the studies are of one plane, and contact-area and load bring slices of their own");
    };
    leave_out(scene.tilt.has_value(), "[tilt]");
    leave_out(scene.slices.has_value(), "[slices]");
    if (scene.coning)
        notes.emplace_back(
            "[coning] left out: outlines are measured in the plane of the middle as the wave generator shapes a ring, "
            "which an elastic cup follows only nearly; contact-area measures with it, load with the elastic cup in its "
            "place");
    plain.tilt.reset();
    plain.slices.reset();
    if (scene.circular_spline.root_clearance > 0)
        notes.emplace_back("root_clearance left out: it is the difference of two given lengths");
    plain.circular_spline.root_clearance = 0;
    if (scene.circular_spline.automatic_backlash)
        notes.emplace_back("backlash_offset = \"auto\" left out: measured with none");
    plain.circular_spline.automatic_backlash = false;
    plain.wedm.reset();
    return plain;
}

namespace {

Measured measured(Scene const& scene, int points, int positions)
{
    StudyDrive drive = study_drive(scene);
    ReferenceCurve reference = reference_of(drive);
    double const entry = entry_of(drive, reference, points, positions);
    return {std::move(drive), std::move(reference), entry};
}

}  // namespace

Case case_of(Scene const& scene, std::vector<Study> const& chosen, int points, int positions)
{
    Case made{scene, {}, {}};
    if (std::none_of(chosen.begin(), chosen.end(), has_outline))
        return made;
    made.own = measured(scene, points, positions);
    bool const compared =
        std::any_of(chosen.begin(), chosen.end(), [](Study const& s) { return s.outline == study_motion_model; });
    if (compared && scene.solver.kinematics != Kinematics::exact) {
        Scene exact = scene;
        exact.solver.kinematics = Kinematics::exact;
        made.exact = measured(exact, points, positions);
    }
    return made;
}

std::vector<std::unique_ptr<Case>> designs_of(Scene const& scene, std::vector<Study> const& chosen, std::uint64_t seed,
                                              int first, int count, int threads)
{
    std::vector<std::unique_ptr<Case>> made(static_cast<std::size_t>(count));
    parallel_for(made.size(), threads, 1, [&](std::size_t i) {
        try {
            Scene design = design_near(scene, seed, first + static_cast<int>(i));
            design.solver.threads = 1;
            if (!check_scene(design).empty())
                return;
            constexpr int points = 24, positions = 600;
            made[i] = std::make_unique<Case>(case_of(design, chosen, points, positions));
            if (!made[i]->own)
                (void)solve(design);
        } catch (NumericalError const& error) {
            if (!error.is_infeasible() && error.code() != ErrorCode::no_reference)
                throw;
            made[i].reset();  // counted as refused
        } catch (InputError const&) {
            made[i].reset();
        }
    });
    std::erase(made, nullptr);
    return made;
}

void run_study(Study const& study, Case const& drive, StudyRun const& run, Scene const& coned)
{
    if (has_outline(study)) {
        Measured const& against = drive.against(study);
        study.outline({{run.report, against.drive.scene, run.name, run.repeats, run.quick, run.sampled, run.threads},
                       against.drive,
                       against.reference});
        return;
    }
    study.axial({run.report, study.axial == study_contact_area ? coned : drive.scene, run.name, run.repeats, run.quick,
                 run.sampled, run.report.threads});
}

}  // namespace hdconj::accuracy
