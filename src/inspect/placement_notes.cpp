// SPDX-License-Identifier: GPL-3.0-or-later
#include "placement_notes.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <map>

#include "base/text.hpp"
#include "measured_planes.hpp"

namespace hdconj::inspect {
namespace {

/// Whether all points lie off the flanks to one side, as centres of a ball do whose radius is not given.
void add_note_of_probe(Inspection& result)
{
    constexpr double far = 4;  // in standard deviations: errors of a part go to both sides
    double sum = 0, squares = 0, count = 0;
    for (PointDeviation const& point : result.points)
        if (point.fate == PointFate::used) {
            sum += point.deviation;
            squares += point.deviation * point.deviation;
            ++count;
        }
    double const mean = count > 0 ? sum / count : 0;
    double const deviation = count > 0 ? std::sqrt(std::max(0.0, squares / count - mean * mean)) : 0;
    if (std::abs(mean) > far * deviation && std::abs(mean) > plane_thickness)
        result.notes.push_back(fmt::format(
            "all points lie about {} mm {} the material: is the probe's radius missing, or of the other sign?",
            short_number(std::abs(mean), 2), mean > 0 ? "outside" : "inside"));
}

/// Errors that come into a figure so many times as large are told.
constexpr double weak = 2;

}  // namespace

void add_note_of_sector(Inspection& result, CommonErrorsKnown known, Eigen::MatrixXd const& inverse,
                        Eigen::MatrixXd const& rows)
{
    constexpr double small_part = 0.05;
    if (result.options.registration == Registration::least_squares && known != CommonErrorsKnown::all)
        result.notes.push_back(fmt::format(
            "the points do not tell {}slope and crowning from the position of the part: what flanks have of these in "
            "common changes it, beyond the intervals; write --register turn if the axis is known",
            known == CommonErrorsKnown::none ? "thickness, " : ""));
    // its eigenvalues are 1 over the squared sines of the angles between both; the largest is hardly below this
    double const squared = (inverse * (rows.transpose() * rows)).trace() - static_cast<double>(rows.cols() - 1);
    double const part = 1 - 1 / squared;
    bool const zone = result.options.registration == Registration::minimum_zone;
    if (zone && part > small_part)
        result.notes.push_back(fmt::format(
            "a minimum zone of these teeth takes up to {:.0f} % of what all flanks have in common (thickness, slope, "
            "crowning) for a shift: write --register turn if the axis is known, else least-squares",
            100 * part));
    else if (!zone && squared > weak * weak)
        result.notes.push_back(fmt::format(
            "the teeth hardly tell a shift from thickness, slope and crowning: errors of another form that all flanks "
            "share come into these up to {:.0f}-fold, beyond the intervals; write --register turn if the axis is known",
            std::sqrt(squared)));
}

void add_notes_of_points(Inspection& result, std::size_t groups)
{
    std::map<int, double> plane_of;
    bool const shared = std::ranges::any_of(result.flanks, [&](FlankFigures const& flank) {
        return plane_of.emplace(flank.tooth, flank.z).first->second != flank.z;
    });
    if (result.nominal.size() > 1 && !shared)
        result.notes.push_back(fmt::format(
            "the {} planes have no tooth in common, and pitch and runout are those within a plane: if they are one "
            "plane of a part that leans, lay it flat or leave the column z out",
            result.nominal.size()));
    if (result.repeated > 0)
        result.notes.push_back(fmt::format("{} {} in the file again, and {} used once", result.repeated,
                                           result.repeated == 1 ? "point stands" : "points stand",
                                           result.repeated == 1 ? "is" : "are"));
    add_note_of_probe(result);
    if (result.flanks.empty())
        result.notes.push_back(fmt::format(
            "no flank has {} points over {:g} % of its length: there are deviations, but no figures of flanks",
            fewest_points, 100 * least_cover));
    else if (groups > result.flanks.size())
        result.notes.push_back(
            fmt::format("{} of {} flanks have fewer than {} points, or points over less than {:g} % "
                        "of their length: they have no figures",
                        groups - result.flanks.size(), groups, fewest_points, 100 * least_cover));
}

}  // namespace hdconj::inspect
