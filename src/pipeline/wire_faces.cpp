// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include "drive.hpp"
#include "hdconj/conjugate/outline.hpp"
#include "hdconj/geometry/rigid_motion.hpp"
#include "hdconj/numeric/error.hpp"
#include "hdconj/pipeline/wedm.hpp"
#include "hdconj/wedm/offset_path.hpp"
#include "wire_job.hpp"

namespace hdconj {
namespace {

using namespace detail;

/// A draft deeper than the radius of a corner folds the outline back there: that loop is no part of the face.
void trim(WireFaces& faces)
{
    TrimmedPath const trimmed = without_loops(faces.pitch);
    if (trimmed.path.size() == faces.pitch.size())
        return;
    std::vector<char> meshing;
    for (double const at : trimmed.at)
        meshing.push_back(at < 0 ? 0 : faces.meshing[static_cast<std::size_t>(at)]);  // where it was folded there is no flank
    for (SectionBetween& between : faces.between)
    {
        std::vector<Vec2> points;
        for (std::size_t i = 0; i < trimmed.at.size(); ++i)
        {
            // loops between the faces are no longer than those of the faces, and their corner lies on the ruling that joins those
            Vec2 const ruling = trimmed.path.lower[i] + between.share * (trimmed.path.upper[i] - trimmed.path.lower[i]);
            points.push_back(trimmed.at[i] < 0 ? ruling : between.points[static_cast<std::size_t>(trimmed.at[i])]);
        }
        between.points = std::move(points);
    }
    for (std::size_t& mark : faces.marks)
    {
        // a mark in the loop becomes its corner
        std::size_t i = 0;
        while (i + 1 < trimmed.at.size() && !(trimmed.at[i] >= static_cast<double>(mark)))
            ++i;
        while (i > 0 && trimmed.at[i] > static_cast<double>(mark) && trimmed.at[i - 1] < 0)
            --i;
        mark = i;
    }
    faces.marks.erase(std::unique(faces.marks.begin(), faces.marks.end()), faces.marks.end());
    faces.meshing = std::move(meshing);
    faces.pitch = trimmed.path;
}

/// One tooth from left root to right root, y from the axis of the part.
struct ToothLine
{
    std::vector<Vec2> points;
    std::size_t tip_first = 0;  ///< corners of the tip land; the same where there is none
    std::size_t tip_last = 0;
};

ToothLine tooth_line(Profile const& tooth, double chord, double r_m)
{
    ToothLine line;
    line.points = {start_of(tooth.pieces.front().shape).point};
    bool found = false;
    for (std::size_t i = 0; i < tooth.pieces.size(); ++i)
    {
        std::size_t const before = line.points.size() - 1;
        PieceShape const& shape = tooth.pieces[i].shape;
        int const steps = tooth.pieces[i].corner ? 0 : steps_of(shape, chord);
        for (int k = 1; k <= steps; ++k)
            line.points.push_back(point_at(shape, static_cast<double>(k) / steps));
        if (is_tip(tooth, static_cast<int>(i)))
        {
            line.tip_first = found ? line.tip_first : before;
            line.tip_last = line.points.size() - 1;
            found = true;
        }
    }
    for (Vec2& p : line.points)
        p.y() += r_m;
    return line;
}

/// The tooth that was solved for.
ToothLine tooth_line(Solution const& solution)
{
    ToothLine line;
    line.points = solution.flexspline_outline;
    for (OutlinePiece const& piece : solution.flexspline_pieces)
    {
        if (piece.kind == "land")
        {
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
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
    {
        bool const across = points[i].x() < 0 && points[i + 1].x() >= 0;
        if (across && (edge == points.size() || points[i].y() > points[edge].y()))
            edge = i;
    }
    if (edge == points.size())
        throw NumericalError("wedm", "flexspline tooth", "its outline does not cross its centre line");
    std::size_t const middle = edge + 1;
    if (points[middle].x() > 0)
    {
        Vec2 const& a = points[edge];
        Vec2 const& b = points[middle];
        points.insert(points.begin() + static_cast<std::ptrdiff_t>(middle), Vec2(0, a.y() + (b.y() - a.y()) * (-a.x() / (b.x() - a.x()))));
        line.tip_last += line.tip_last >= middle ? 1 : 0;
        line.tip_first += line.tip_first >= middle ? 1 : 0;
    }
    if (line.tip_first == line.tip_last)
        line.tip_first = line.tip_last = middle;
    return middle;
}

/// Set-ups hand over in the middle of a tip, where a wire must be able to come straight in.
void refuse_edge(ToothLine const& line, std::size_t middle, Scene const& scene)
{
    Vec2 const before = line.points[middle] - line.points[middle - 1];
    Vec2 const after = line.points[middle + 1] - line.points[middle];
    constexpr double sharp = 0.02;  // [rad], above what the chords of a round tip turn by
    bool const edge = std::abs(std::atan2(cross(before, after), before.dot(after))) > sharp;
    bool const narrow = line.tip_first < line.tip_last && (line.points[line.tip_last] - line.points[line.tip_first]).norm() < scene.wedm->tolerance;
    if (edge || narrow)
        throw InputError(Fault{scene.given_profile().path, scene.given_profile().line, "", "the tooth ends in an edge, and the two set-ups meet in the middle of a tip land",
                               "give the tooth a tip land with a smaller addendum"});
}

/// From @p from to @p to, both ends left out: at the radius of both about the axis, or evenly from one to the other; an odd number of points, so that the
/// middle is one.
void add_root(std::vector<Vec2>& points, Vec2 const& from, Vec2 const& to, double chord)
{
    double const begin = std::atan2(from.x(), from.y());
    double const width = std::atan2(to.x(), to.y()) - begin;
    if (!(width > 0))
        throw NumericalError("wedm", "root of the flexspline", "two teeth meet above it: nothing is left between them");
    double const r = from.norm();
    double const step = 2 * std::acos(1 - std::min(0.5, chord / r));
    int const count = 2 * std::max(1, static_cast<int>(std::ceil(width / step / 2)));
    for (int k = 1; k < count; ++k)
    {
        double const share = static_cast<double>(k) / count;
        double const angle = begin + share * width;
        points.push_back((r + share * (to.norm() - r)) * Vec2(std::sin(angle), std::cos(angle)));
    }
}

}  // namespace

WireFaces wire_faces(CircularSplineOutline const& outline, int teeth)
{
    WireFaces faces;
    faces.teeth = teeth;
    auto const reversed = [](std::vector<Vec2> const& points) { return std::vector<Vec2>(points.rbegin(), points.rend()); };
    faces.pitch = {reversed(outline.outline.front()), reversed(outline.outline.back())};
    std::size_t const last = faces.pitch.size() - 1;
    for (auto mark = outline.landmarks.rbegin(); mark != outline.landmarks.rend(); ++mark)
        faces.marks.push_back(last - static_cast<std::size_t>(*mark));
    faces.meshing.assign(faces.pitch.size(), 0);
    // marks: land corner, flank end, middle, flank end, land corner
    if (faces.marks.size() == 5)
        for (std::size_t i = 0; i <= last; ++i)
            faces.meshing[i] = (i >= faces.marks[0] && i <= faces.marks[1]) || (i >= faces.marks[3] && i <= faces.marks[4]) ? 1 : 0;
    else
        throw NumericalError("wedm", "outline", "has no land corners and flank ends");
    for (std::size_t k = 1; k + 1 < outline.outline.size(); ++k)
        faces.between.push_back({(outline.z[k] - outline.z.front()) / (outline.z.back() - outline.z.front()), reversed(outline.outline[k])});
    trim(faces);
    return faces;
}

WireFaces flexspline_faces(Scene const& scene, StageObserver const& on_stage)
{
    double const chord = scene.solver.tolerance;
    ToothLine line;
    if (scene.is_reverse())
    {
        line = tooth_line(solve(scene, on_stage));
    }
    else
    {
        Faults faults = check_scene(scene);
        if (!faults.empty())
            throw InputError(faults);
        Profile const tooth = given_tooth(scene, faults);
        line = tooth_line(tooth, chord, ring_geometry(scene, tooth).r_m);
    }
    std::size_t const middle = split_tip(line);
    refuse_edge(line, middle, scene);
    WireFaces faces;
    faces.teeth = scene.drive.flexspline_teeth;
    faces.external = true;
    double const half = std::numbers::pi / faces.teeth;
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
    faces.marks = {line.tip_last - middle, right_root, (right_root + left_root) / 2, left_root, left_root + line.tip_first};
    faces.meshing.assign(points.size(), 0);
    for (std::size_t i = 0; i < points.size(); ++i)
        faces.meshing[i] = (i >= faces.marks[0] && i <= right_root) || (i >= left_root && i <= faces.marks[4]) ? 1 : 0;
    return faces;
}

}  // namespace hdconj
