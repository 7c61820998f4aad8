// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh.hpp"

#include <fmt/format.h>
#include <limits>
#include <numbers>

#include "hdconj/error.hpp"
#include "hdconj/units.hpp"

namespace hdconj::cam {
namespace {

constexpr double at_end = 0x1p-10;      ///< of a flank: contact this near its end has reached it
constexpr std::size_t fewest_rows = 6;  ///< in mesh, of which a second derivative is taken

/// Second derivative at row @p i of the mesh, by a difference of order four to one side.
double bend_at(std::vector<MeshPoint> const& points, std::size_t i, double step)
{
    bool const back = i >= 4;
    auto const slope = [&](std::size_t k) { return points[back ? i - k : i + k].slope; };
    double const sum = 25 * slope(0) - 48 * slope(1) + 36 * slope(2) - 16 * slope(3) + 3 * slope(4);
    return (back ? sum : -sum) / (12 * step);
}

}  // namespace

double row_angle(std::size_t row, int waves)
{
    return std::numbers::pi / waves * static_cast<double>(row) / half_wave_rows;
}

std::string why_parted(FlankPair const& pair, MeshPoint const& last)
{
    double const near = at_end * pair.inner().length();
    struct End
    {
        double distance;
        char const* name;
    };
    End const ends[] = {{pair.inner().from_tip(last.contact.inner), "the tip end of the flexspline's flank"},
                        {pair.inner().from_root(last.contact.inner), "the root end of the flexspline's flank"},
                        {pair.outer().from_tip(last.contact.outer), "the tip end of the circular spline's flank"},
                        {pair.outer().from_root(last.contact.outer), "the root end of the circular spline's flank"}};
    for (End const& end : ends)
        if (end.distance < near)
            return std::string("contact reaches ") + end.name;
    return "no inclination of the tooth beyond lets the flanks touch without overlap";
}

Mesh mesh_of(FlankPair const& pair, CurveRule const& rule, int waves, double major, double tolerance)
{
    return mesh_from(mesh_begin(pair, rule, waves, major, std::numbers::pi / waves / 2, tolerance), pair, rule, waves,
                     tolerance);
}

Mesh mesh_from(MeshBegin const& begin, FlankPair const& pair, CurveRule const& rule, int waves, double tolerance)
{
    Mesh mesh{begin, {}, 0};
    while (mesh.first < half_wave_rows && row_angle(mesh.first, waves) < mesh.begin.point.x)
        ++mesh.first;
    std::vector<double> angles;
    for (std::size_t i = mesh.first; i <= half_wave_rows; ++i)
        angles.push_back(row_angle(i, waves));
    mesh.curve = march(pair, rule, mesh.begin.point, angles, tolerance);
    if (mesh.curve.points.size() < fewest_rows)
        throw NumericalError(
            ErrorCode::no_contact, "neutral curve", fmt::format("u = {:.6g} deg", to_deg(mesh.curve.last.x)),
            fmt::format("the flanks stop touching there, {:.3g} deg after they began: {}",
                        to_deg(mesh.curve.last.x - mesh.begin.point.x), why_parted(pair, mesh.curve.last)),
            "give teeth that are conjugate to each other on some neutral curve, or another "
            "wave_generator.major_displacement");
    return mesh;
}

MeshClosing closing_of(FlankPair const& pair, CurveRule const& rule, int waves, double major, Mesh const& mesh)
{
    std::vector<MeshPoint> const& points = mesh.curve.points;
    BendingLimit const limit(rule, waves, major);
    double const step = row_angle(1, waves);
    std::size_t bounded = 0;
    while (bounded < points.size() &&
           limit.keeps(points[bounded].state[0], points[bounded].slope, bend_at(points, bounded, step)))
        ++bounded;
    if (bounded == points.size() && mesh.last() == half_wave_rows)
        return {mesh.last(), {}};
    for (std::size_t i = bounded; i-- > fewest_rows;) {
        EvenPolynomial const rest =
            completion(rule, points[i], bend_at(points, i, step), row_angle(half_wave_rows, waves));
        if (limit.keeps(rest))
            return {mesh.first + i, rest};
    }
    throw NumericalError(
        ErrorCode::no_solution, "neutral curve", fmt::format("u = {:.6g} deg", to_deg(mesh.curve.last.x)),
        fmt::format("the flanks stop touching there, because {}, and no curve of bounded curvature goes on from any "
                    "part of the mesh, which begins at {:.4g} deg: it would be hollow, or bent more than {:g} times as "
                    "a cosine of that displacement",
                    why_parted(pair, mesh.curve.last), to_deg(mesh.begin.first), most_bending),
        "write another wave_generator.major_displacement, or give teeth that are conjugate to each other over a longer "
        "stretch");
}

std::vector<WantedCurveRow> closed_rows(Mesh const& mesh, MeshClosing const& closing, int waves)
{
    constexpr double no_error = std::numeric_limits<double>::quiet_NaN();
    double const half_wave = row_angle(half_wave_rows, waves);
    std::vector<WantedCurveRow> rows;
    for (std::size_t i = 0; i <= half_wave_rows; ++i) {
        double const u = row_angle(i, waves);
        bool const before = i<mesh.first, beyond = i> closing.last;
        if (before || beyond) {
            EvenPolynomial::Value const at = before ? mesh.begin.to_axis(u) : closing.rest(half_wave - u);
            rows.push_back({u, at.value, before ? at.slope : -at.slope, 0, no_error, false});
        } else {
            MeshPoint const& point = mesh.curve.points[i - mesh.first];
            rows.push_back({u, point.state[0], point.slope, 0, 0, true});
        }
    }
    return rows;
}

}  // namespace hdconj::cam
