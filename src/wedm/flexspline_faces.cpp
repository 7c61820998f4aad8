// SPDX-License-Identifier: GPL-3.0-or-later
// Faces of the flexspline: one tooth, and the root beside it.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "drive/drive.hpp"
#include "faces.hpp"
#include "hdconj/base/rigid_motion.hpp"
#include "hdconj/check.hpp"
#include "hdconj/error.hpp"

namespace hdconj::wedm {
namespace {

/// One tooth from left root to right root, y from the axis of the part.
struct ToothLine
{
    std::vector<Vec2> points;
    std::size_t tip_first = 0;  ///< corners of the tip land; the same where there is none
    std::size_t tip_last = 0;
};

/// @p tooth in chords of at most @p chord, at the radius @p r_m of the neutral circle.
ToothLine tooth_line(profile::Profile const& tooth, double chord, double r_m)
{
    ToothLine line;
    line.points = {profile::start_of(tooth.pieces.front().shape).point};
    bool found = false;
    for (std::size_t i = 0; i < tooth.pieces.size(); ++i) {
        std::size_t const before = line.points.size() - 1;
        profile::PieceShape const& shape = tooth.pieces[i].shape;
        int const steps = tooth.pieces[i].corner ? 0 : profile::steps_of(shape, chord);
        for (int k = 1; k <= steps; ++k)
            line.points.push_back(profile::point_at(shape, static_cast<double>(k) / steps));
        if (profile::is_tip(tooth, static_cast<int>(i))) {
            line.tip_first = found ? line.tip_first : before;
            line.tip_last = line.points.size() - 1;
            found = true;
        }
    }
    for (Vec2& p : line.points)
        p.y() += r_m;
    return line;
}

/// The tooth that the scene gives.
ToothLine tooth_line(Scene const& scene)
{
    Faults faults = check_scene(scene);
    throw_if_any(faults);
    profile::Profile const tooth = drive::given_tooth(scene, faults);
    return tooth_line(tooth, scene.solver.tolerance, drive::ring_geometry(scene, tooth).r_m);
}

/// The tooth that was solved for.
ToothLine tooth_line(Solution const& solution)
{
    ToothLine line;
    line.points = solution.flexspline_outline;
    for (OutlinePiece const& piece : solution.flexspline_pieces) {
        if (piece.kind == "land") {
            line.tip_first = piece.first;
            line.tip_last = piece.last;
        }
    }
    for (Vec2& p : line.points)
        p.y() += solution.geometry.r_m + solution.geometry.pitch_line;
    return line;
}

/// Makes the point of the tip on the centre line a vertex.
/// @return its index
std::size_t split_tip(ToothLine& line)
{
    std::vector<Vec2>& points = line.points;
    std::size_t edge = points.size();
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        bool const across = points[i].x() < 0 && points[i + 1].x() >= 0;
        if (across && (edge == points.size() || points[i].y() > points[edge].y()))
            edge = i;
    }
    if (edge == points.size())
        throw NumericalError(ErrorCode::no_outline, "wedm", "flexspline tooth",
                             "its outline does not cross its centre line");
    std::size_t const middle = edge + 1;
    if (points[middle].x() > 0) {
        Vec2 const& a = points[edge];
        Vec2 const& b = points[middle];
        points.insert(points.begin() + static_cast<std::ptrdiff_t>(middle),
                      Vec2(0, a.y() + (b.y() - a.y()) * (-a.x() / (b.x() - a.x()))));
        line.tip_last += line.tip_last >= middle ? 1 : 0;
        line.tip_first += line.tip_first >= middle ? 1 : 0;
    }
    if (line.tip_first == line.tip_last)
        line.tip_first = line.tip_last = middle;
    return middle;
}

/// Whether the tooth ends in an edge, or in a land narrower than @p tolerance. Set-ups meet in the middle of a tip,
/// where a wire must be able to come straight in.
bool has_edge(ToothLine const& line, std::size_t middle, double tolerance)
{
    Vec2 const before = line.points[middle] - line.points[middle - 1];
    Vec2 const after = line.points[middle + 1] - line.points[middle];
    constexpr double sharp = 0.02;  // [rad], above what the chords of a round tip turn by
    return std::abs(std::atan2(cross(before, after), before.dot(after))) > sharp ||
           (line.tip_first < line.tip_last &&
            (line.points[line.tip_last] - line.points[line.tip_first]).norm() < tolerance);
}

/// From @p from to @p to, both ends left out: at the radius of both about the axis, or evenly from one to the other; an
/// odd number of points, so that the middle is one.
void add_root(std::vector<Vec2>& points, Vec2 const& from, Vec2 const& to, double chord)
{
    double const begin = std::atan2(from.x(), from.y());
    double const width = std::atan2(to.x(), to.y()) - begin;
    if (!(width > 0))
        throw NumericalError(ErrorCode::no_outline, "wedm", "root of the flexspline",
                             "two teeth meet above it: nothing is left between them");
    double const r = from.norm();
    double const step = 2 * std::acos(1 - std::min(0.5, chord / r));
    int const count = 2 * std::max(1, static_cast<int>(std::ceil(width / step / 2)));
    for (int k = 1; k < count; ++k) {
        double const share = static_cast<double>(k) / count;
        double const angle = begin + share * width;
        points.push_back((r + share * (to.norm() - r)) * Vec2(std::sin(angle), std::cos(angle)));
    }
}

/// One pitch from the middle of a tip to that of the next, teeth upright. @param middle  of the tip
WireFaces faces_of_tooth(ToothLine const& line, std::size_t middle, int teeth, double chord)
{
    WireFaces faces;
    faces.teeth = teeth;
    faces.external = true;
    double const half = std::numbers::pi / teeth;
    std::vector<Vec2>& points = faces.pitch.lower;
    for (std::size_t i = middle; i < line.points.size(); ++i)
        points.push_back(turned_clockwise(line.points[i], -half));
    std::size_t const right_root = points.size() - 1;
    Vec2 const next_root = turned_clockwise(line.points.front(), half);
    add_root(points, points.back(), next_root, chord);
    std::size_t const left_root = points.size();
    for (std::size_t i = 0; i <= middle; ++i)
        points.push_back(turned_clockwise(line.points[i], half));
    faces.pitch.upper = faces.pitch.lower;
    faces.marks = {line.tip_last - middle, right_root, (right_root + left_root) / 2, left_root,
                   left_root + line.tip_first};
    faces.meshing.assign(points.size(), 0);
    mark_flank(faces, faces.marks[0], right_root);
    mark_flank(faces, left_root, faces.marks[4]);
    return faces;
}

}  // namespace

WireFaces flexspline_faces(Scene const& scene, Solution const* solved)
{
    ToothLine line = solved != nullptr ? tooth_line(*solved) : tooth_line(scene);
    std::size_t const middle = split_tip(line);
    if (has_edge(line, middle, scene.wedm->tolerance))
        throw InputError(Fault{scene.given_profile().path, scene.given_profile().line, "",
                               "the tooth ends in an edge, and the two set-ups meet in the middle of a tip land",
                               "give the tooth a tip land with a smaller addendum"});
    return faces_of_tooth(line, middle, scene.drive.flexspline_teeth, scene.solver.tolerance);
}

}  // namespace hdconj::wedm
