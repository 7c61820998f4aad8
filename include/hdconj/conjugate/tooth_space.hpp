// SPDX-License-Identifier: GPL-3.0-or-later
// The circular spline's tooth space: which stretch of which contact arc bounds it, in order.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hdconj/base/tolerance.hpp"
#include "hdconj/conjugate/arc_polygons.hpp"
#include "hdconj/conjugate/boundary_piece.hpp"
#include "hdconj/conjugate/crossing.hpp"
#include "hdconj/envelope/branch.hpp"
#include "hdconj/error.hpp"
#include "hdconj/region/outer_boundary.hpp"

namespace hdconj::conjugate {

/// Finds the tooth space of design 3.3 for the bounding arcs of an envelope: outer boundary of the swept region,
/// neighbours included, cut at the tip circle.
///
/// Polygons of the arcs decide only which arc follows which; where two arcs cross, the corner is then solved on the
/// arcs themselves. If the polygons mislead (a corner does not converge where they cross), they are made 16 times
/// finer.
///
/// A flank that was itself made by two conjugate zones touches the space twice. Two arcs then run side by side, and
/// where they cross is known worse than where they are. If the finest polygons still find no corner between arcs that
/// are no farther apart than a small part of the tolerance, the boundary changes from one to the other across the gap.
template <motion::RelativeMotion Motion>
class ToothSpaceFinder
{
  public:
    /// @param chord  chord error of the first polygons [mm]
    ToothSpaceFinder(envelope::Envelope<Motion> const& envelope, std::vector<envelope::ContactArc> const& arcs,
                     double tip_radius, int teeth, Tolerance tolerance, double chord)
        : envelope_(envelope),
          arcs_(arcs),
          tip_radius_(tip_radius),
          pitch_(2 * std::numbers::pi / teeth),
          tolerance_(tolerance),
          chord_(chord)
    {
    }

    [[nodiscard]] ToothSpace operator()()
    {
        double chord = chord_;
        constexpr int attempts = 5;
        for (int attempt = 0; attempt < attempts; ++attempt, chord /= 16) {
            across_gaps_ = attempt + 1 == attempts;
            if (auto const space = find(std::max(chord, tolerance_.coincidence()), attempt > 0))
                return *space;
        }
        throw NumericalError(code_, "region", place_,
                             "the boundary of the tooth space could not be put together: " + cause_, remedy_, set_);
    }

  private:
    [[nodiscard]] std::optional<ToothSpace> find(double chord, bool graded)
    {
        swept_ = swept_polygons(envelope_, arcs_, tip_radius_, pitch_, chord, graded);
        swept_.refuse_without_land(tip_radius_, envelope_.offset());
        refuse_short_flanks(chord);
        swept_.join_ends(tolerance_.coincidence());
        int const floor = swept_.add_floor(tip_radius_, chord);
        region::OuterBoundary const boundary =
            region::outer_boundary(swept_.polygons(), floor, tolerance_.coincidence());
        segments_ += boundary.segments;
        // at the rim of the window curves hang loose because their neighbours were left out
        for (Vec2 const& p : boundary.loose) {
            if (std::abs(std::atan2(p.x(), p.y())) > pitch_ / 2)
                continue;
            return fail(ErrorCode::no_outline, near_text(p), "the curves of contact that bound it there do not meet",
                        remedy_of_open_boundary);
        }
        std::vector<region::BoundaryRun> const runs = middle_pitch(boundary.runs, floor);
        if (runs.empty())
            return fail(ErrorCode::no_land, "tip circle", "it does not come down to a land on both sides",
                        "write a larger circular_spline.inner_radius, or a smaller wave_generator.radial_deformation",
                        swept_.wider_tip(tip_radius_));
        return refine(runs, floor, chord);
    }

    std::nullopt_t fail(ErrorCode code, std::string place, std::string cause, std::string remedy,
                        std::vector<std::string> set = {})
    {
        code_ = code;
        place_ = std::move(place);
        cause_ = std::move(cause);
        remedy_ = std::move(remedy);
        set_ = std::move(set);
        return std::nullopt;
    }

    /// A flank that ends with the tooth's own profile, at its root, outside of all others and above the tip circle
    /// bounds nothing from there down.
    void refuse_short_flanks(double chord) const
    {
        int const last = static_cast<int>(envelope_.profile().pieces.size()) - 1;
        double highest = 0;
        for (envelope::ContactArc const& arc : arcs_)
            for (auto const& [u, t] : {std::pair(arc.u_begin, arc.t_begin), std::pair(arc.u_end, arc.t_end)}) {
                if (!arc.bounding || !((arc.piece == 0 && t == 0) || (arc.piece == last && t == 1)))
                    continue;
                Vec2 const end = envelope_.point(arc, u).p;
                if (end.norm() > tip_radius_ && end.norm() > swept_.radius_at({std::atan2(end.x(), end.y())}) - chord)
                    highest = std::max(highest, end.norm());
            }
        if (highest > tip_radius_)
            throw NumericalError(
                ErrorCode::no_land, "region", "tip circle",
                "a flank ends at a radius of " + std::to_string(highest) +
                    " mm, where the flexspline's tooth ends at its root, and does not come down to the tip circle at " +
                    std::to_string(tip_radius_) + " mm",
                "write a circular_spline.inner_radius above " + std::to_string(highest) +
                    ", a larger dedendum of the flexspline's tooth or a smaller circular_spline.backlash_offset",
                {"circular_spline.inner_radius=" + std::to_string(highest + (highest - tip_radius_) / 4)});
    }

    /// The runs from the land at -half a pitch to the land at +half a pitch; nothing when the walk did not pass them.
    [[nodiscard]] std::vector<region::BoundaryRun> middle_pitch(std::vector<region::BoundaryRun> const& runs,
                                                                int floor) const
    {
        auto const land_over = [&](double angle) {
            return std::find_if(runs.begin(), runs.end(), [&](region::BoundaryRun const& run) {
                return run.curve == floor && swept_.u_at(floor, run.begin) <= angle &&
                       swept_.u_at(floor, run.end) >= angle;
            });
        };
        auto const left = land_over(-pitch_ / 2);
        auto const right = land_over(pitch_ / 2);
        if (left == runs.end() || right == runs.end() || left == right)
            return {};
        return {left, right + 1};
    }

    /// Exact ends of every run; nothing when two neighbours do not meet where their polygons say.
    [[nodiscard]] std::optional<ToothSpace> refine(std::vector<region::BoundaryRun> runs, int floor, double chord)
    {
        ToothSpace space;
        space.segments = segments_;
        for (region::BoundaryRun const& run : runs) {
            SweptPolygons::Source const& source = swept_.source(run.curve);
            space.pieces.push_back(
                {source.arc, source.copy, swept_.u_at(run.curve, run.begin), swept_.u_at(run.curve, run.end)});
        }
        space.pieces.front().begin = -pitch_ / 2;
        space.pieces.back().end = pitch_ / 2;
        for (std::size_t i = 0; i + 1 < runs.size(); ++i) {
            auto const& before = swept_.polygon(runs[i].curve);
            auto const& after = swept_.polygon(runs[i + 1].curve);
            BoundaryPiece& a = space.pieces[i];
            BoundaryPiece& b = space.pieces[i + 1];
            if (runs[i].curve != floor && runs[i + 1].curve != floor &&
                shared_end(before, runs[i].end, after, runs[i + 1].begin))
                continue;
            bool met = false;
            if (runs[i].curve == floor)
                met = cut_at_tip(b, b.begin, a.end, chord);
            else if (runs[i + 1].curve == floor)
                met = cut_at_tip(a, a.end, b.begin, chord);
            else
                met = meet(a, b, chord);
            if (!met)
                return std::nullopt;
        }
        drop_roundings(space.pieces);
        space.gap = gap_;
        return space;
    }

    /// Where several branches meet in a point, which is a joint of the profile, they cross there more than once within
    /// rounding: what lies between is no stretch.
    void drop_roundings(std::vector<BoundaryPiece>& pieces) const
    {
        constexpr double shallow =
            16;  // branches that meet at a small angle are cut by more than their own rounding apart
        double const nothing = shallow * tolerance_.roundoff();
        auto const is_rounding = [&](BoundaryPiece const& piece) {
            if (piece.arc < 0)
                return false;
            TurnedArc<Motion> const arc = turned(piece);
            Vec2 const begin = arc.point(piece.begin).p;
            return (arc.point(piece.end).p - begin).norm() <= nothing &&
                   (arc.point(0.5 * (piece.begin + piece.end)).p - begin).norm() <= nothing;
        };
        pieces.erase(std::remove_if(pieces.begin(), pieces.end(), is_rounding), pieces.end());
        for (std::size_t i = 1; i < pieces.size();) {
            BoundaryPiece& before = pieces[i - 1];
            BoundaryPiece const& piece = pieces[i];
            bool const forward = before.begin < before.end, same = piece.arc >= 0 && before.arc == piece.arc &&
                                                                   before.copy == piece.copy &&
                                                                   forward == (piece.begin < piece.end);
            if (same && (turned(before).point(before.end).p - turned(piece).point(piece.begin).p).norm() <= nothing) {
                before.end = piece.end;
                pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(i));
            } else
                ++i;
        }
    }

    [[nodiscard]] TurnedArc<Motion> turned(BoundaryPiece const& piece) const
    {
        return {envelope_, arcs_[static_cast<std::size_t>(piece.arc)], piece.copy * pitch_};
    }

    bool cut_at_tip(BoundaryPiece const& piece, double& u, double& angle, double chord)
    {
        TurnedArc<Motion> const arc = turned(piece);
        auto const exact = crossing_with_circle(arc, tip_radius_, u, chord);
        if (!exact)
            return fail(ErrorCode::no_land, "tip circle", "a flank only touches the tip circle",
                        "write another circular_spline.inner_radius"),
                   false;
        u = *exact;
        Vec2 const p = arc.point(u).p;
        angle = std::atan2(p.x(), p.y());
        return true;
    }

    bool meet(BoundaryPiece& a, BoundaryPiece& b, double chord)
    {
        TurnedArc<Motion> const arc_a = turned(a);
        TurnedArc<Motion> const arc_b = turned(b);
        auto const exact = crossing_of_arcs(arc_a, a.end, arc_b, b.begin, chord, tolerance_);
        if (!exact && across_gaps_) {
            constexpr double small_part = 0x1p-4;  // of the tolerance, as in ToothBodyFinder
            NearestOnArc const there = nearest_on(arc_b, arc_a.point(a.end).p, b.begin);
            if (there.gap <= small_part * tolerance_.length) {
                b.begin = there.u;
                gap_ = std::max(gap_, there.gap);
                return true;
            }
        }
        if (!exact)
            return fail(ErrorCode::no_outline, near_text(arc_a.point(a.end).p),
                        "two curves of contact that bound it there only come close", remedy_of_open_boundary),
                   false;
        a.end = (*exact)[0];
        b.begin = (*exact)[1];
        return true;
    }

    envelope::Envelope<Motion> const& envelope_;
    std::vector<envelope::ContactArc> const& arcs_;
    double tip_radius_;
    double pitch_;
    Tolerance tolerance_;
    double chord_;
    SweptPolygons swept_{pitch_};
    std::size_t segments_ = 0;
    bool across_gaps_ = false;
    double gap_ = 0;
    ErrorCode code_ = ErrorCode::no_outline;
    std::string place_ = "tooth space";
    std::string cause_, remedy_;
    std::vector<std::string> set_;  ///< what may help, as arguments of --set
};

}  // namespace hdconj::conjugate
