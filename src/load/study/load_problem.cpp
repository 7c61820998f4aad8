// SPDX-License-Identifier: GPL-3.0-or-later
#include "load_problem.hpp"

#include <numbers>

#include "flank_deviation.hpp"
#include "load/round_edges.hpp"

namespace hdconj::load {

LoadProblem load_problem(contact::ContactContext const& context, ElasticDrive const& drive,
                         contact::FlankGrid const& flanks)
{
    Scene const& scene = context.scene;
    return {context, drive, flanks,
            with_round_edges(flanks, edge_radius(scene), std::numbers::pi / scene.drive.circular_spline_teeth),
            flank_deviation(context, flanks)};
}

double edge_radius(Scene const& scene)
{
    constexpr double standard = 0.04;  // of the module
    return scene.load && scene.load->edge_radius ? *scene.load->edge_radius : standard * scene.drive.module;
}

std::size_t spaces_of(LoadProblem const& problem)
{
    return static_cast<std::size_t>(problem.context.scene.drive.circular_spline_teeth /
                                    problem.drive.response->sectors());
}

double search_limit(LoadProblem const& problem)
{
    constexpr double limit = 0.15;  // of the module
    return limit * problem.context.scene.drive.module;
}

double gap_tolerance(LoadProblem const& problem)
{
    constexpr double tolerance = 4e-6;  // of the module: 1 nm on type-50
    return tolerance * problem.context.scene.drive.module;
}

FlankSearch flank_search(LoadProblem const& problem, double turn, double limit, double depth)
{
    constexpr double standard_depth = 4e-4;  // of the module: 0.1 um on type-50, as of Hertz strips at 18 N/mm
    auto const& drive = problem.context.scene.drive;
    auto const whole = static_cast<std::size_t>(drive.circular_spline_teeth);
    std::size_t const spaces = spaces_of(problem);
    // the sector around the major axis, so that a picture shows the mesh in one piece
    return {turn,
            limit,
            (whole - spaces) / 2,
            spaces,
            problem.drive.phase,
            drive.flexspline_teeth,
            depth * standard_depth * drive.module};
}

contact::GapField gap_field(LoadProblem const& problem, LoadedShape const& shape, contact::FlankGrid const& flanks)
{
    auto const& drive = problem.context.scene.drive;
    return {problem.context.tooth,
            flanks,
            shape.places,
            drive.flexspline_teeth,
            drive.circular_spline_teeth,
            problem.drive.phase,
            problem.deviation ? &*problem.deviation : nullptr};
}

}  // namespace hdconj::load
