// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What an error estimate must be: a bound of the true error, which a reference in 50 digits tells, and not far above
/// it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "hdconj/base/parallel.hpp"
#include "hdconj/solve.hpp"
#include "support/catch.hpp"
#include "support/oracle/reference_outline.hpp"
#include "support/random_designs.hpp"

namespace oracle {

/// What was looked at.
struct EstimateTally
{
    std::size_t solved = 0, ends = 0;
    std::size_t unjudged = 0;    ///< for want of a reference that is fine enough
    double largest_land = 0;     ///< estimate of a land's error, in modules
    std::vector<double> over{};  ///< estimate over true error, increasing

    [[nodiscard]] double median() const { return over.empty() ? 0 : over[over.size() / 2]; }
};

/// Solves every scene and checks outline, single figures and ends of zones against the reference; several scenes at a
/// time.
inline EstimateTally estimates_bound(std::vector<hdconj::Scene> const& scenes, std::string const& what)
{
    using namespace hdconj;
    struct Outcome
    {
        hdconj::accuracy::CurveDifference difference{};
        double estimate = 0, reference_error = 0;
        bool solved = false;
        std::string refused{};
        std::vector<hdconj::accuracy::ZoneEndCheck> ends{};
        hdconj::ErrorEstimate stated{}, off{};  ///< of the single figures
    };
    std::vector<Outcome> outcomes(scenes.size());
    hdconj::parallel_for(scenes.size(), 0, 1, [&](std::size_t i) {
        Outcome& outcome = outcomes[i];
        hdconj::Scene const& scene = scenes[i];
        try {
            hdconj::Solution const solution = hdconj::solve(scene);
            hdconj::accuracy::ReferenceCurve const truth = hdconj::accuracy::reference_outline(scene);
            outcome.difference = truth.compare(
                scene.is_reverse() ? solution.flexspline_outline : solution.circular_spline.outline.front(),
                4 * scene.solver.tolerance);
            outcome.estimate = solution.error.chord + solution.error.point;
            outcome.reference_error = truth.error();
            outcome.stated = solution.error;
            if (!scene.is_reverse()) {
                hdconj::accuracy::ReferenceFigures const figures = hdconj::accuracy::reference_figures(scene, truth);
                hdconj::PairGeometry const& g = solution.geometry;
                outcome.off.r_0 = std::abs(g.r_0 - figures.r_0);
                outcome.off.space_depth = std::abs(g.space_depth - figures.space_depth);
                outcome.off.land = std::abs(2 * g.land_half_angle * g.circular_spline_inner_radius - figures.land);
            }
            outcome.ends = hdconj::accuracy::check_zone_ends(solution);
            outcome.solved = true;
        } catch (std::exception const& error) {
            outcome.refused = error.what();
        }
    });
    EstimateTally tally;
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        Outcome const& outcome = outcomes[i];
        if (!outcome.solved) {
            std::cout << "estimate, " << what << ": design " << i << ": " << outcome.refused << '\n';
            continue;
        }
        // a reference judges what is a hundred times its own error
        constexpr double finer = 100;
        if (finer * outcome.reference_error > scenes[i].solver.tolerance) {
            ++tally.unjudged;
            std::cout << "estimate, " << what << ": design " << i << ": reference right to " << outcome.reference_error
                      << " mm only\n";
            continue;
        }
        ++tally.solved;
        double const error = outcome.difference.hausdorff;
        INFO("design " << i << ", tolerance " << scenes[i].solver.tolerance << ", " << what << "\n"
                       << (scenes[i].is_reverse() ? std::string() : designs::toml_of(scenes[i])));
        CHECK(outcome.difference.missed == 0);
        CHECK(error <= outcome.estimate);
        // the tolerance is for chords; what vertices are off by, some 1e-12 mm, comes on top
        CHECK(error <= scenes[i].solver.tolerance + outcome.stated.point);
        // a series of a shape that is solved for has coefficients with roundings of r_m, which no estimate of the
        // program states
        bool const by_series = scenes[i].solver.kinematics == hdconj::Kinematics::material &&
                               scenes[i].wave_generator.shape.family != "cosine";
        constexpr double roundings = 0x1p-45;
        double const unstated =
            by_series ? roundings * scenes[i].drive.module * scenes[i].drive.flexspline_teeth / 2 : 0;
        CHECK(outcome.difference.points <= outcome.stated.point + unstated);
        tally.over.push_back(outcome.estimate / error);
        // the single figures that are printed
        CHECK(outcome.off.r_0 <= outcome.stated.r_0);
        CHECK(outcome.off.space_depth <= outcome.stated.space_depth);
        CHECK(outcome.off.land <= outcome.stated.land);
        tally.largest_land = std::max(tally.largest_land, outcome.stated.land / scenes[i].drive.module);
        for (hdconj::accuracy::ZoneEndCheck const& end : outcome.ends) {
            INFO(end.segment_name);
            CHECK((by_series || end.off <= end.stated));
        }
        tally.ends += outcome.ends.size();
    }
    std::sort(tally.over.begin(), tally.over.end());
    if (!tally.over.empty())
        std::cout << "estimate over true error, " << what << ", " << tally.solved << " designs: least "
                  << tally.over.front() << ", median " << tally.median() << ", largest " << tally.over.back() << '\n';
    return tally;
}

}  // namespace oracle
