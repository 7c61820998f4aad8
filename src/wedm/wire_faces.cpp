// SPDX-License-Identifier: GPL-3.0-or-later
// Faces of the circular spline, from the outlines of its slices.
#include <algorithm>
#include <numbers>
#include <utility>

#include "faces.hpp"
#include "hdconj/base/rigid_motion.hpp"
#include "hdconj/base/tolerance.hpp"
#include "hdconj/error.hpp"
#include "offset_path.hpp"

namespace hdconj::wedm {
Vec2 turned_to(Vec2 const& point, int space, int teeth)
{
    return space == 0 ? point : turned_clockwise(point, 2 * std::numbers::pi * space / teeth);
}

std::vector<Vec2> turned_to(std::vector<Vec2> const& points, int space, int teeth)
{
    std::vector<Vec2> turned;
    turned.reserve(points.size());
    for (Vec2 const& p : points)
        turned.push_back(turned_to(p, space, teeth));
    return turned;
}

std::vector<Vec2> with_neighbours(std::vector<Vec2> const& points, WireFaces const& faces, std::size_t more)
{
    std::vector<Vec2> line;
    // the last point of the pitch before is this one's first
    for (std::size_t i = points.size() - 1 - more; i + 1 < points.size(); ++i)
        line.push_back(turned_to(points[i], -faces.next(), faces.teeth));
    line.insert(line.end(), points.begin(), points.end());
    for (std::size_t i = 1; i <= more; ++i)
        line.push_back(turned_to(points[i], faces.next(), faces.teeth));
    return line;
}

namespace {

/// A draft deeper than the radius of a corner folds the outline back there: that loop is no part of the face.
void trim(WireFaces& faces)
{
    TrimmedPath const trimmed = without_loops(faces.pitch);
    if (trimmed.path.size() == faces.pitch.size())
        return;
    for (SectionBetween& between : faces.between) {
        std::vector<Vec2> points;
        for (std::size_t i = 0; i < trimmed.at.size(); ++i) {
            // loops between the faces are no longer than those of the faces, and their corner lies on the ruling that
            // joins those
            Vec2 const ruling = trimmed.path.lower[i] + between.share * (trimmed.path.upper[i] - trimmed.path.lower[i]);
            points.push_back(trimmed.at[i] < 0 ? ruling : between.points[static_cast<std::size_t>(trimmed.at[i])]);
        }
        between.points = std::move(points);
    }
    for (std::size_t& mark : faces.marks) {
        // a mark in the loop becomes its corner
        std::size_t i = 0;
        while (i + 1 < trimmed.at.size() && !(trimmed.at[i] >= static_cast<double>(mark)))
            ++i;
        while (i > 0 && trimmed.at[i] > static_cast<double>(mark) && trimmed.at[i - 1] < 0)
            --i;
        mark = i;
    }
    for (std::vector<char>* const marked : {&faces.meshing, &faces.wall}) {
        std::vector<char> kept;
        for (double const at : trimmed.at)  // where it was folded there is no flank
            kept.push_back(at < 0 ? 0 : (*marked)[static_cast<std::size_t>(at)]);
        *marked = std::move(kept);
    }
    faces.pitch = trimmed.path;
}

/// The section half way between the faces where straight lines join these.
std::vector<Vec2> middle_of(PairedPath const& pitch)
{
    std::vector<Vec2> points;
    for (std::size_t i = 0; i < pitch.size(); ++i)
        points.emplace_back(0.5 * (pitch.lower[i] + pitch.upper[i]));
    return points;
}

/// Continues the straight rulings of @p faces from the ends of the toothing, at the heights @p first and @p last, to
/// the faces of a workpiece of @p thickness with its middle at z = 0. The ends become sections between the faces.
void continue_to_faces(WireFaces& faces, double first, double last, double thickness)
{
    double const width = last - first, half = thickness / 2;
    for (SectionBetween& between : faces.between)
        between.share = (first + between.share * width + half) / thickness;
    faces.between.insert(faces.between.begin(), {(first + half) / thickness, faces.pitch.lower});
    faces.between.push_back({(last + half) / thickness, faces.pitch.upper});
    for (std::size_t i = 0; i < faces.pitch.size(); ++i) {
        Vec2 const slope = (faces.pitch.upper[i] - faces.pitch.lower[i]) / width;
        faces.pitch.lower[i] -= (first + half) * slope;
        faces.pitch.upper[i] += (half - last) * slope;
    }
}

}  // namespace

WireFaces wire_faces(CircularSplineOutline const& outline, int teeth, double thickness, bool straight)
{
    WireFaces faces;
    faces.teeth = teeth;
    auto const reversed = [](std::vector<Vec2> const& points) {
        return std::vector<Vec2>(points.rbegin(), points.rend());
    };
    faces.pitch = {reversed(outline.outline.front()), reversed(outline.outline.back())};
    std::size_t const last = faces.pitch.size() - 1;
    for (auto mark = outline.landmarks.rbegin(); mark != outline.landmarks.rend(); ++mark)
        faces.marks.push_back(last - static_cast<std::size_t>(*mark));
    // marks: land corner, flank end, middle, flank end, land corner
    if (faces.marks.size() != 5)
        throw NumericalError(ErrorCode::no_outline, "wedm", "outline", "has no land corners and flank ends");
    faces.meshing.assign(last + 1, 0);
    mark_flank(faces, faces.marks[0], faces.marks[1]);
    mark_flank(faces, faces.marks[3], faces.marks[4]);
    faces.wall.assign(last + 1, 0);
    for (OutlinePiece const& piece : outline.pieces)
        if (piece.kind == "flank" || piece.kind == "corner")
            for (std::size_t i = piece.first; i <= piece.last; ++i)
                faces.wall[last - i] = 1;
    for (std::size_t k = 1; k + 1 < outline.outline.size(); ++k)
        faces.between.push_back({(outline.z[k] - outline.z.front()) / (outline.z.back() - outline.z.front()),
                                 reversed(outline.outline[k])});
    bool const differ = outline.outline.size() > 1;
    faces.knows_sections = outline.outline.size() != 2 || straight;
    if (outline.outline.size() == 2 && straight)
        faces.between.push_back({0.5, middle_of(faces.pitch)});
    if (differ && thickness - (outline.z.back() - outline.z.front()) > Tolerance{thickness, thickness}.coincidence())
        continue_to_faces(faces, outline.z.front(), outline.z.back(), thickness);
    trim(faces);
    // where corners alone touch, a flank begins and ends in one point
    faces.marks.erase(std::unique(faces.marks.begin(), faces.marks.end()), faces.marks.end());
    return faces;
}

}  // namespace hdconj::wedm
