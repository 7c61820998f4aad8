// SPDX-License-Identifier: GPL-3.0-or-later
#include "matched_outline.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

#include "boundary_track.hpp"
#include "hdconj/base/parallel.hpp"
#include "hdconj/error.hpp"

namespace hdconj::conjugate {
namespace {

/// The stretches of one half of one slice between its landmarks, in the order of increasing x.
struct HalfIntervals
{
    std::vector<BoundaryStretch> bottom, flank, land;
};

bool around_bottom(BoundaryStretch const& s)
{
    return s.kind == OutlineKind::corner || s.kind == OutlineKind::bottom;
}

[[noreturn]] void refuse_without_flank(bool right, std::size_t slice, std::size_t slices)
{
    bool const several = slices > 1;
    throw NumericalError(
        ErrorCode::no_flank, "slices",
        std::string(right ? "right" : "left") + " half of the tooth space" +
            (several ? ", slice " + std::to_string(slice + 1) + " of " + std::to_string(slices) : ""),
        "has no flank between its bottom and the tip circle; the tip of the tooth alone makes the "
        "space",
        several ? "write a smaller circular_spline.width or slices.surface = \"tilted\"" : "take another tooth");
}

/// The right half of @p slice runs bottom, flank, land; the left one the other way round.
HalfIntervals intervals_of(std::vector<ToothSpaceBoundary const*> const& slices, std::size_t slice, bool right)
{
    ToothSpaceBoundary const& curve = *slices[slice];
    auto const& pieces = curve.pieces();
    auto const middle = std::find_if(pieces.begin(), pieces.end(), [&](BoundaryPiece const& piece) {
        return 0.5 * (curve.at(piece, piece.begin).p + curve.at(piece, piece.end).p).x() > 0;
    });
    std::vector<BoundaryPiece> half =
        right ? std::vector<BoundaryPiece>(middle, pieces.end()) : std::vector<BoundaryPiece>(pieces.begin(), middle);
    std::vector<BoundaryStretch> stretches = stretches_of(curve, half);
    if (!right)
        std::reverse(stretches.begin(), stretches.end());
    HalfIntervals found;
    auto const flank = std::ranges::find_if(stretches, [](BoundaryStretch const& s) { return !around_bottom(s); });
    auto const land = std::find_if(stretches.begin(), stretches.end(),
                                   [](BoundaryStretch const& s) { return s.kind == OutlineKind::land; });
    if (flank == stretches.end() || land == stretches.end() || flank >= land)
        refuse_without_flank(right, slice, slices.size());
    found.bottom.assign(stretches.begin(), flank);
    found.flank.assign(flank, land);
    found.land.assign(land, stretches.end());
    if (!right)
        for (auto* interval : {&found.bottom, &found.flank, &found.land})
            std::reverse(interval->begin(), interval->end());
    return found;
}

bool same_stretches(std::vector<std::vector<BoundaryStretch> const*> const& slices)
{
    return std::all_of(slices.begin(), slices.end(), [&](auto const* stretches) {
        return std::equal(stretches->begin(), stretches->end(), slices.front()->begin(), slices.front()->end(),
                          [](BoundaryStretch const& a, BoundaryStretch const& b) {
                              return a.kind == b.kind && a.segment == b.segment;
                          });
    });
}

/// One stretch of every slice: by profile parameter on flanks where it is monotone everywhere, else by length.
OutlineUnit unit_of(std::vector<ToothSpaceBoundary const*> const& curves,
                    std::vector<std::vector<BoundaryStretch>> const& stretches, OutlineKind kind, int segment,
                    bool by_profile, double chord, bool rulings, int threads)
{
    OutlineUnit unit;
    unit.kind = kind;
    unit.segment = segment;
    for (Measure const measure : {Measure::profile, rulings ? Measure::rulings : Measure::length}) {
        if (measure == Measure::profile && !by_profile)
            continue;
        std::vector<std::optional<BoundaryTrack>> tracks(curves.size());
        parallel_for(curves.size(), threads, 1,
                     [&](std::size_t k) { tracks[k].emplace(*curves[k], stretches[k], measure, chord); });
        unit.tracks.clear();
        for (std::optional<BoundaryTrack>& track : tracks)
            unit.tracks.push_back(std::move(*track));
        if (std::all_of(unit.tracks.begin(), unit.tracks.end(), [](BoundaryTrack const& t) { return t.monotone(); }))
            break;
    }
    return unit;
}

/// The units of one interval: stretch by stretch where all slices have the same, else as a whole.
void add_interval(std::vector<OutlineUnit>& units, std::vector<ToothSpaceBoundary const*> const& curves,
                  std::vector<std::vector<BoundaryStretch> const*> const& slices, OutlineKind kind, double chord,
                  bool rulings, int threads, bool& by_origin)
{
    bool const same = same_stretches(slices);
    by_origin = by_origin && same;
    std::size_t const count = same ? slices.front()->size() : 1;
    for (std::size_t i = 0; i < count; ++i) {
        std::vector<std::vector<BoundaryStretch>> stretches;
        for (auto const* each : slices)
            stretches.push_back(same ? std::vector<BoundaryStretch>{(*each)[i]} : *each);
        BoundaryStretch const& first = stretches.front().front();
        OutlineKind const made = same ? first.kind : kind;
        units.push_back(unit_of(curves, stretches, made, same ? first.segment : -1, same && made == OutlineKind::flank,
                                chord, rulings, threads));
    }
}

/// The units of both halves, or of the right one where the left is its image.
struct Units
{
    std::vector<OutlineUnit> units;
    std::array<std::size_t, 5> marks{};  ///< number of units before each landmark
    bool symmetric = false;
    bool by_origin = true;
};

Units units_of(std::vector<ToothSpaceBoundary const*> const& slices, double chord, bool rulings, int threads)
{
    Units all;
    all.symmetric = std::ranges::all_of(slices, [](ToothSpaceBoundary const* curve) { return curve->symmetric(); });
    for (bool const right : {false, true}) {
        if (!right && all.symmetric)
            continue;
        std::vector<HalfIntervals> halves;
        for (std::size_t k = 0; k < slices.size(); ++k)
            halves.push_back(intervals_of(slices, k, right));
        auto const of = [&](auto member) {
            std::vector<std::vector<BoundaryStretch> const*> interval;
            for (HalfIntervals const& half : halves)
                interval.push_back(&(half.*member));
            return interval;
        };
        // a bottom that only some slices have cannot be told from the flank
        bool const all_have_bottom =
            std::all_of(halves.begin(), halves.end(), [](HalfIntervals const& h) { return !h.bottom.empty(); });
        if (!all_have_bottom) {
            for (HalfIntervals& half : halves) {
                half.flank.insert(right ? half.flank.begin() : half.flank.end(), half.bottom.begin(),
                                  half.bottom.end());
                half.bottom.clear();
            }
        }
        auto const add = [&](auto member, OutlineKind kind) {
            add_interval(all.units, slices, of(member), kind, chord, rulings, threads, all.by_origin);
        };
        if (right) {
            all.marks[2] = all.units.size();
            if (all_have_bottom)
                add(&HalfIntervals::bottom, OutlineKind::bottom);
            all.marks[3] = all.units.size();
            add(&HalfIntervals::flank, OutlineKind::flank);
            all.marks[4] = all.units.size();
            add(&HalfIntervals::land, OutlineKind::land);
        } else {
            add(&HalfIntervals::land, OutlineKind::land);
            all.marks[0] = all.units.size();
            add(&HalfIntervals::flank, OutlineKind::flank);
            all.marks[1] = all.units.size();
            if (all_have_bottom)
                add(&HalfIntervals::bottom, OutlineKind::bottom);
        }
    }
    return all;
}

/// @param flank_intervals  along the flank of one half, whose units share them
void sample_all(Units& all, double chord, int flank_intervals, int threads)
{
    double flank = 0;
    for (std::size_t i = all.marks[3]; i < all.marks[4]; ++i)
        flank += all.units[i].length();
    for (std::size_t i = 0; i < all.units.size(); ++i) {
        bool const on_flank =
            (i >= all.marks[3] && i < all.marks[4]) || (!all.symmetric && i >= all.marks[0] && i < all.marks[1]);
        sample(all.units[i], chord,
               on_flank && flank > 0 ? static_cast<int>(std::ceil(flank_intervals * all.units[i].length() / flank)) : 0,
               threads);
    }
}

/// Points and stretches of all units, one after the other. Returns the index of the last point of each, after a first
/// 0.
std::vector<std::size_t> join(Units const& all, std::size_t slices, MatchedOutline& out)
{
    out.points.resize(slices);
    out.normals.resize(slices);
    std::vector<std::size_t> ends{0};
    for (std::size_t u = 0; u < all.units.size(); ++u) {
        OutlineUnit const& unit = all.units[u];
        // where a flank begins, the corner moves with the flank
        bool const begins_flank = u == all.marks[3] || (!all.symmetric && u == all.marks[0]);
        std::size_t const first = out.points.front().empty() ? 0 : out.points.front().size() - 1;
        for (std::size_t k = 0; k < slices; ++k) {
            if (begins_flank && !out.normals[k].empty())
                out.normals[k].back() = unit.at[k].front().after;
            for (std::size_t i = out.points[k].empty() ? 0 : 1; i < unit.stations.size(); ++i) {
                out.points[k].push_back(unit.at[k][i].p);
                out.normals[k].push_back(unit.at[k][i].before);
            }
        }
        out.chord = std::max(out.chord, unit.chord);
        ends.push_back(out.points.front().size() - 1);
        out.stretches.push_back({unit.kind, unit.segment, first, ends.back()});
    }
    return ends;
}

/// Adds the left half, the image of the right one bit for bit. Returns the index of the middle.
std::size_t add_image(MatchedOutline& out, profile::Profile const& tooth)
{
    std::size_t const half = out.points.front().size() - 1;
    for (std::size_t k = 0; k < out.points.size(); ++k) {
        auto& p = out.points[k];
        auto& n = out.normals[k];
        p.front().x() = 0;
        std::vector<Vec2> points, normals;
        for (std::size_t i = half; i > 0; --i) {
            points.emplace_back(-p[i].x(), p[i].y());
            normals.emplace_back(-n[i].x(), n[i].y());
        }
        p.insert(p.begin(), points.begin(), points.end());
        n.insert(n.begin(), normals.begin(), normals.end());
    }
    std::vector<OutlineStretch> whole = mirrored(out.stretches, tooth, half);
    for (OutlineStretch s : out.stretches)
        whole.push_back({s.kind, s.segment, s.first + half, s.last + half});
    out.stretches = std::move(whole);
    return half;
}

}  // namespace

MatchedOutline matched_outline(std::vector<ToothSpaceBoundary const*> const& slices, double chord, int flank_intervals,
                               int threads, bool rulings)
{
    Units all = units_of(slices, chord, rulings, threads);
    sample_all(all, chord, flank_intervals, threads);
    MatchedOutline out;
    out.by_origin = all.by_origin;
    std::vector<std::size_t> const ends = join(all, slices.size(), out);
    auto const& marks = all.marks;
    if (!all.symmetric) {
        for (std::size_t i = 0; i < marks.size(); ++i)
            out.landmarks[i] = ends[marks[i]];
        return out;
    }
    std::size_t const half = add_image(out, slices.front()->tooth());
    for (std::size_t i = 2; i < marks.size(); ++i) {
        out.landmarks[i] = half + ends[marks[i]];
        out.landmarks[4 - i] = half - ends[marks[i]];
    }
    return out;
}

}  // namespace hdconj::conjugate
