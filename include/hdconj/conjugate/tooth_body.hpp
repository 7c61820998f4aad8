// SPDX-License-Identifier: GPL-3.0-or-later
// The reverse problem's tooth: what teeth moving around it leave, and which stretch of which contact arc bounds it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "hdconj/base/tolerance.hpp"
#include "hdconj/conjugate/body_polygons.hpp"
#include "hdconj/conjugate/crossing.hpp"
#include "hdconj/conjugate/tooth_flank.hpp"
#include "hdconj/conjugate/tooth_space.hpp"
#include "hdconj/error.hpp"
#include "hdconj/region/outer_boundary.hpp"

namespace hdconj::conjugate {

/// How far the tooth may reach in its own frame [mm].
struct BodyLimits
{
    double tip = 0;         ///< y of the tip
    double root = 0;        ///< y of the root
    double half_width = 0;  ///< half the pitch at the root
    double addendum = 0;    ///< height of the tip above the pitch line
};

/// The flanks, each from the tip to its foot; `copy` of a piece is the index of the tooth that sweeps it.
struct ToothBody
{
    std::vector<BoundaryPiece> left;
    std::vector<BoundaryPiece> right;
    std::size_t segments = 0;  ///< given to the arrangement, all attempts
    double gap = 0;            ///< largest distance between branches that were taken for one [mm]
};

/// Finds the largest tooth around the y axis that none of the moving teeth penetrates, cut flat at the tip.
///
/// What the moving teeth sweep hangs down on both sides of the axis. The tooth is the part of the rest that is reached
/// from below. Its flanks are followed from the tip down to their feet. At a foot the other tooth touches with the end
/// of its tip: the contact normal is along its own centre line. A flank also ends where half the pitch is reached.
/// Polygons decide only which arc follows which, as in ToothSpaceFinder; every corner is solved on the arcs.
///
/// A flank that was itself made by two conjugate zones touches the tooth twice. Two branches then run side by side,
/// closer than rounding can separate. Where they have no corner, and are no farther apart than a small part of the
/// tolerance, the flank changes from one to the other across the gap.
template <motion::RelativeMotion Motion>
class ToothBodyFinder
{
  public:
    /// @param chord  chord error of the first polygons [mm]
    ToothBodyFinder(std::vector<SweptTooth<Motion>> const& teeth, BodyLimits const& limits, Tolerance tolerance,
                    double chord)
        : teeth_(teeth), limits_(limits), tolerance_(tolerance), chord_(chord)
    {
    }

    [[nodiscard]] ToothBody operator()()
    {
        double chord = chord_;
        constexpr int attempts = 5;
        for (int attempt = 0; attempt < attempts; ++attempt, chord /= 16) {
            constexpr int strict = 2;
            across_gaps_ = attempt >= strict;
            if (auto const body = find(std::max(chord, tolerance_.coincidence()), attempt > 0))
                return *body;
        }
        throw NumericalError(ErrorCode::no_outline, "region", place_,
                             "the boundary of the flexspline tooth could not be put together: " + cause_,
                             remedy_of_open_boundary);
    }

  private:
    using Runs = std::vector<region::BoundaryRun>;

    [[nodiscard]] std::optional<ToothBody> find(double chord, bool graded)
    {
        swept_ = body_polygons(teeth_, limits_.tip, chord, graded);
        refuse_without_land();
        swept_.join_ends(tolerance_.coincidence());
        // beyond the feet curves of the outermost teeth may end below the tip, and would let the walk in behind them
        constexpr double beyond_the_feet = 1.25;
        for (double const side : {-1.0, 1.0})
            swept_.add_wall(side * beyond_the_feet * limits_.half_width, limits_.tip, limits_.half_width);
        floor_ = swept_.add_floor_line(limits_.tip, limits_.half_width);
        region::OuterBoundary const boundary =
            region::outer_boundary(swept_.polygons(), floor_, tolerance_.coincidence());
        segments_ += boundary.segments;
        // farther out curves hang loose because more teeth were left out
        for (Vec2 const& p : boundary.loose)
            if (std::abs(p.x()) <= limits_.half_width)
                return fail(p, "the curves of contact that bound it there do not meet");
        Runs const& runs = boundary.runs;
        auto const land = std::find_if(runs.begin(), runs.end(), [&](region::BoundaryRun const& run) {
            return run.curve == floor_ && swept_.u_at(floor_, run.begin) >= 0 && swept_.u_at(floor_, run.end) <= 0;
        });
        if (land == runs.end())
            return fail({0, limits_.tip}, "the boundary does not come to the tip of the tooth");
        ToothBody body;
        gap_ = 0;
        // the walk along the tip goes from right to left
        Runs const right(std::make_reverse_iterator(land), runs.rend());
        Runs const left(land + 1, runs.end());
        body.segments = segments_;
        if (!follow(right, 1, chord, body.right) || !follow(left, -1, chord, body.left))
            return std::nullopt;
        if (gap_ > 0) {
            body.right = without_changes(teeth_, body.right, smallest_step(), gap_);
            body.left = without_changes(teeth_, body.left, smallest_step(), gap_);
        }
        body.gap = gap_;
        return body;
    }

    std::nullopt_t fail(Vec2 const& where, std::string cause)
    {
        place_ = near_text(where) + " of the flexspline tooth's frame";
        cause_ = std::move(cause);
        return std::nullopt;
    }

    void refuse_without_land() const
    {
        double const lowest = swept_.lowest_at({0});
        if (!(lowest < limits_.tip))
            return;
        double const half_land = SweptPolygons::half_land * 2 * limits_.half_width,
                     addendum = limits_.addendum - (limits_.tip - swept_.lowest_at({-half_land, half_land}));
        bool const has_any = addendum > 0;
        std::string const value = std::to_string(addendum), key = "flexspline.addendum";
        throw NumericalError(ErrorCode::no_outline, "region", "tip of the flexspline tooth",
                             "the circular spline's teeth sweep down to " + std::to_string(limits_.tip - lowest) +
                                 " mm below it on the tooth's centre line, so that the tooth would be pointed there",
                             "write " + (has_any ? key + " = " + value : "a smaller " + key) +
                                 ", or a smaller circular_spline.profile.addendum",
                             has_any ? std::vector{key + "=" + value} : std::vector<std::string>{});
    }

    /// One flank. @p runs  from the tip outward, as the walk met them; @p side  1: right, -1: left
    bool follow(Runs const& runs, int side, double chord, std::vector<BoundaryPiece>& flank)
    {
        // positions in the order in which the flank is followed
        auto const first = [&](region::BoundaryRun const& run) { return side > 0 ? run.end : run.begin; };
        auto const last = [&](region::BoundaryRun const& run) { return side > 0 ? run.begin : run.end; };
        auto const piece_of = [&](region::BoundaryRun const& run) {
            SweptPolygons::Source const& source = swept_.source(run.curve);
            return BoundaryPiece{source.arc, source.copy, swept_.u_at(run.curve, first(run)),
                                 swept_.u_at(run.curve, last(run))};
        };
        auto const at_tip = [&](BoundaryPiece const& piece, double& u) {
            auto const exact = crossing_at_height(
                of(piece), [&](Vec2 const& p) { return p.y() - limits_.tip; }, u, chord);
            u = exact.value_or(u);
            return exact.has_value();
        };
        auto const of_a_tooth = [&](region::BoundaryRun const& run) { return swept_.source(run.curve).arc >= 0; };
        for (std::size_t i = 0; i < runs.size() && of_a_tooth(runs[i]); ++i) {
            BoundaryPiece piece = flank.empty() ? piece_of(runs[i]) : next_;
            if (flank.empty() && !at_tip(piece, piece.begin))
                return fail(point(piece, piece.begin), "a flank only touches the tip"), false;
            bool const more = i + 1 < runs.size() && of_a_tooth(runs[i + 1]);
            bool met = true;
            if (more) {
                next_ = piece_of(runs[i + 1]);
                met = shared_end(swept_.polygon(runs[i].curve), last(runs[i]), swept_.polygon(runs[i + 1].curve),
                                 first(runs[i + 1])) ||
                      meet(piece, next_, chord);
            }
            auto const foot = conjugate::foot_on(teeth_[static_cast<std::size_t>(piece.copy)], piece,
                                                 swept_.source(runs[i].curve).u, side, limits_.half_width);
            if (!met && !foot)  // beyond the foot curves may hang loose
                return false;
            if (foot && *foot == piece.begin)
                return !flank.empty() || (fail(point(piece, piece.begin), "the flank ends at the tip"), false);
            flank.push_back(piece);
            if (foot) {
                flank.back().end = *foot;
                return true;
            }
            if (!more)
                return fail(point(piece, piece.end), "a flank comes back to the tip before it reached its foot"), false;
        }
        return fail({0, limits_.tip}, "a side of the tooth has no flank"), false;
    }

    bool meet(BoundaryPiece& a, BoundaryPiece& b, double chord)
    {
        auto const exact = crossing_of_arcs(of(a), a.end, of(b), b.begin, chord, tolerance_);
        if (!exact && across_gaps_ && change_over(a, b))
            return true;
        if (!exact)
            return fail(point(a, a.end), "two curves of contact that bound it there only come close"), false;
        a.end = (*exact)[0];
        b.begin = (*exact)[1];
        return true;
    }

    [[nodiscard]] double smallest_step() const
    {
        constexpr double small_part = 0x1p-4;
        return small_part * tolerance_.length;
    }

    /// The flank leaves @p a at its end for the nearest point of @p b, if that is near enough.
    bool change_over(BoundaryPiece const& a, BoundaryPiece& b)
    {
        NearestOnArc const there = nearest_on(of(b), point(a, a.end), b.begin);
        if (!(there.gap <= smallest_step()))
            return false;
        b.begin = there.u;
        gap_ = std::max(gap_, there.gap);
        return true;
    }

    [[nodiscard]] TurnedArc<Motion> of(BoundaryPiece const& piece) const { return turned_arc(teeth_, piece); }

    [[nodiscard]] Vec2 point(BoundaryPiece const& piece, double u) const { return of(piece).point(u).p; }

    std::vector<SweptTooth<Motion>> const& teeth_;
    BodyLimits limits_;
    Tolerance tolerance_;
    double chord_;
    SweptPolygons swept_{0};
    int floor_ = -1;
    BoundaryPiece next_;  ///< the piece after the one at hand, its beginning solved
    std::size_t segments_ = 0;
    bool across_gaps_ = false;
    double gap_ = 0;
    std::string place_ = "flexspline tooth";
    std::string cause_;
};

}  // namespace hdconj::conjugate
