// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// `solve` for one motion model: the stages after the motion is known.
#pragma once

#include <algorithm>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "assemble_until_clear.hpp"
#include "centred_outline.hpp"
#include "certificate.hpp"
#include "drive.hpp"
#include "hdconj/conjugate/space_curve.hpp"
#include "hdconj/numeric/parallel.hpp"
#include "late_jobs.hpp"
#include "outline_records.hpp"
#include "records.hpp"
#include "root_clearance.hpp"
#include "stage_clock.hpp"
#include "swallowed.hpp"
#include "turn_check.hpp"

namespace hdconj::detail {

/// Contact arcs of all branches in one list, which boundary pieces index.
[[nodiscard]] inline std::vector<ContactArc> all_arcs(std::vector<Branch> const& branches)
{
    std::vector<ContactArc> arcs;
    for (Branch const& branch : branches)
        arcs.insert(arcs.end(), branch.arcs.begin(), branch.arcs.end());
    return arcs;
}

/// Indices of @p sizes from the largest on, equal ones in their order.
[[nodiscard]] inline std::vector<std::size_t> largest_first(std::vector<double> const& sizes)
{
    std::vector<std::size_t> order(sizes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return sizes[a] > sizes[b]; });
    return order;
}

/// A tooth space and the arcs that its pieces index.
struct TracedSpace
{
    std::vector<ContactArc> arcs;
    ToothSpace space;
};

template<RelativeMotion Motion>
class SolveJob
{
  public:
    SolveJob(Solution& out, Profile const& tooth, Motion const& motion, StageClock& clock)
        : out_(out), tooth_(tooth), motion_(motion), clock_(clock), base_(tooth, motion, 0),
          pitch_(2 * std::numbers::pi / out.scene.drive.circular_spline_teeth),
          tolerance_{out.scene.solver.tolerance, out.geometry.r_m + out.geometry.w0 + tooth.pitch_line + tooth.addendum}
    {
    }

    void operator()()
    {
        records_wanted_ = true;
        find_branches_of_tooth();
        find_boundary();
        clock_.run(Stage::outline, [&] { publish(); });
    }

    /// First half of the work: all that does not depend on the tip circle.
    void find_branches_of_tooth()
    {
        clock_.run(Stage::envelope, [&] { trace(); });
    }

    /// Second half: the boundary down to the tip circle of `out`.geometry, checked over a full turn.
    void find_boundary()
    {
        if (is_moved())
            clock_.run_rest(Stage::backlash, [&] { trace_moved(); });
        auto const wanted = [&] { return out_.scene.circular_spline.backlash_offset - tolerance_.coincidence(); };
        assemble_until_clear(out_, first_chord(), [&](double c) { assemble(c); }, wanted, "");
    }

    /// The radius at which the circular spline's teeth would be pointed, with its side clearance: the teeth sweep all that lies inside it
    /// half-way between two spaces. Accuracy: that of the first polygons.
    [[nodiscard]] double pointed_radius() const
    {
        double const offset = out_.scene.circular_spline.backlash_offset;
        Envelope<Motion> const moved(tooth_, motion_, offset);
        std::vector<ContactArc> const arcs = all_arcs(offset > 0 ? find_branches(moved, out_.threads).branches : branches_);
        return swept_polygons(moved, arcs, out_.geometry.circular_spline_inner_radius, pitch_, first_chord(), false).radius_between_spaces();
    }

    /// The boundary that was found, as a curve. @p owner keeps tooth and motion alive.
    [[nodiscard]] SpaceCurve curve(std::shared_ptr<void const> owner) const
    {
        Halves const halves = cut_at_centre_line(final_envelope(), final_.arcs, final_.space.pieces, pitch_, tolerance_);
        std::vector<BoundaryPiece> pieces = halves.left;
        pieces.insert(pieces.end(), halves.right.begin(), halves.right.end());
        return {std::move(owner), tooth_, ErasedMotion(motion_), final_envelope().offset(), final_.arcs, std::move(pieces),
                out_.geometry.circular_spline_inner_radius, pitch_};
    }

  private:
    [[nodiscard]] double first_chord() const { return (tooth_.addendum + tooth_.dedendum) * 0x1p-12; }
    [[nodiscard]] bool is_moved() const { return out_.plan.has(Stage::backlash); }
    [[nodiscard]] Envelope<Motion> final_envelope() const { return {tooth_, motion_, out_.scene.circular_spline.backlash_offset}; }

    static constexpr double chords_worth_a_thread = 8192;  // of points that are made in rows
    /// About: of a branch as long as the tooth is high.
    [[nodiscard]] double chords_of_a_flank() const { return std::sqrt((tooth_.addendum + tooth_.dedendum) / tolerance_.length); }

    void trace()
    {
        BranchSet set = find_branches(base_, out_.threads, chords_of_a_flank() > chords_worth_a_thread);
        refuse_lost_branches(set.record, tolerance_.length);
        record_doubts(set.record, tooth_, out_.certificate);
        branches_ = std::move(set.branches);
        out_.work.roots_isolated += set.record.roots;
        out_.work.envelope_points += set.record.evaluations;
    }

    /// The branches of the tooth with the side clearance on it.
    void trace_moved()
    {
        BranchSet set = find_branches(final_envelope(), out_.threads);
        refuse_lost_branches(set.record, tolerance_.length);
        moved_branches_ = std::move(set.branches);
    }

    /// Boundary and outline, and the points of all branches. One thread arranges the boundary's polygons, which has little in loops; the others take branches meanwhile, and
    /// then pieces of the outline with it.
    void trace_with_records(double chord)
    {
        records_wanted_ = false;
        std::vector<BranchRecord> records(branches_.size());
        std::vector<std::size_t> evaluations(branches_.size(), 0);
        double const worth_a_thread = batch_motion(motion_) ? chords_worth_a_thread : chords_worth_a_thread / 8;
        auto const grain = static_cast<std::size_t>(std::ceil(worth_a_thread / chords_of_a_flank()));
        std::vector<std::size_t> const order = longest_first();
        LateJobs pieces;
        // who helps at the end is no work that would be worth a thread
        std::size_t const team = std::clamp<std::size_t>((1 + order.size()) / grain, 1, static_cast<std::size_t>(out_.threads));
        parallel_for(order.size() + team, static_cast<int>(team), 1, [&](std::size_t k) {
            if (k == 0)
                return find_pieces(chord, pieces);
            if (k > order.size())
                return pieces.help();
            std::size_t const i = order[k - 1];
            records[i] = branch_record(base_, branches_[i], tolerance_.length, evaluations[i]);
        });
        pieces.finish();
        for (std::size_t count : evaluations)
            out_.work.envelope_points += count;
        out_.branches = std::move(records);
    }

    /// Finds the boundary, and leaves its pieces to be sampled to @p jobs.
    void find_pieces(double chord, LateJobs& jobs)
    {
        try
        {
            trace_boundary(chord);
            std::vector<double> chords;
            for (std::size_t i = 0; i < sampler_->count(); ++i)
                chords.push_back(sampler_->expected(i));
            jobs.open(chords.size(), [this, order = largest_first(chords)](std::size_t k) { sampler_->sample(order[k], 1); });
        }
        catch (...)
        {
            jobs.close();
            throw;
        }
        jobs.help();
    }

    /// Branches in the order of their work: a long one taken last is waited for.
    [[nodiscard]] std::vector<std::size_t> longest_first() const
    {
        std::vector<double> chords(branches_.size(), 0);
        for (std::size_t i = 0; out_.threads > 1 && i < chords.size(); ++i)
            for (ContactArc const& arc : branches_[i].arcs)
                chords[i] += expected_chords(base_, arc, tolerance_.length);
        return largest_first(chords);
    }

    /// Region, side clearance, outline, root clearance and check, with polygons of the given chord error.
    void assemble(double chord)
    {
        clock_.run_rest(Stage::outline, [&] {
            if (records_wanted_)
                trace_with_records(chord);
            else
            {
                trace_boundary(chord);
                for (std::size_t i = 0; i < sampler_->count(); ++i)
                    sampler_->sample(i, out_.threads);
            }
            outline_ = sampler_->joined();
            out_.work.envelope_points += outline_.outline.evaluations;
        });
        clock_.run(Stage::root_clearance, [&] {
            std::size_t const before = outline_.outline.points.size();
            deepen(outline_.outline, outline_.middle, out_.scene.circular_spline.root_clearance);
            outline_.middle += (outline_.outline.points.size() - before) / 2;
        });
        clock_.run(Stage::interference, [&] { check(); });
    }

    /// The boundary's pieces, ready to be sampled.
    void trace_boundary(double chord)
    {
        clock_.run(Stage::region, [&] { final_ = space_at(base_, branches_, chord); });
        clock_.run(Stage::backlash, [&] {
            TracedSpace shifted = space_at(final_envelope(), moved_branches_, chord);
            refuse_swallowed(base_, final_.arcs, final_.space, shifted.arcs, shifted.space, pitch_, out_.scene.circular_spline.backlash_offset, tolerance_.length);
            final_ = std::move(shifted);
        });
        clock_.run(Stage::outline, [&] {
            if (is_moved())
                moved_.emplace(final_envelope());
            sampler_.emplace(moved_ ? *moved_ : base_, final_.arcs, final_.space.pieces, out_.geometry.circular_spline_inner_radius, pitch_, tolerance_);
        });
    }

    [[nodiscard]] TracedSpace space_at(Envelope<Motion> const& envelope, std::vector<Branch> const& branches, double chord)
    {
        TracedSpace traced;
        traced.arcs = all_arcs(branches);
        ToothSpaceFinder<Motion> find(envelope, traced.arcs, out_.geometry.circular_spline_inner_radius, out_.scene.drive.circular_spline_teeth,
                                      tolerance_, chord);
        traced.space = find();
        out_.work.arrangement_edges += traced.space.segments;
        return traced;
    }

    /// Every outline point against every position of every tooth. A symmetric pair's left half is the image of its right one.
    void check()
    {
        FullTurnClearance<Motion> const clearance(tooth_, motion_, pitch_, pitches_per_lobe(out_.scene));
        std::size_t const first = tooth_.mirror_symmetric && motion_.symmetric() ? outline_.middle : 0;
        out_.check = check_turn(clearance, motion_, outline_.outline.points, points_to_check(outline_.outline, first), out_.threads);
    }

    void publish()
    {
        Outline const& outline = outline_.outline;
        CircularSplineOutline& cs = out_.circular_spline;
        cs.z = {0.0};
        cs.outline = {outline.points};
        cs.pieces = piece_records(outline, tooth_);
        Bottom const bottom = bottom_of(outline, outline_.middle);
        std::size_t const left_land = outline.stretches.front().last;
        std::size_t const right_land = outline.stretches.back().first;
        for (std::size_t index : {left_land, bottom.first, outline_.middle, bottom.last, right_land})
            cs.landmarks.push_back(static_cast<int>(index));
        measure_space(outline, left_land, right_land, pitch_, out_.geometry, out_.error);
        out_.error.chord = outline.chord;
        out_.error.point = outline.error;
        out_.error.clearance = out_.error.point + tolerance_.roundoff();
        for (std::size_t i = 0; i < branches_.size(); ++i)
        {
            std::size_t const before = out_.zones.size();
            append_zones(base_, branches_[i], i, final_.arcs, final_.space.pieces, out_.zones);
            for (std::size_t k = before; k < out_.zones.size(); ++k)
                out_.branches[i].on_boundary = out_.branches[i].on_boundary || out_.zones[k].on_boundary;
        }
        tooth_family();
    }

    void tooth_family()
    {
        constexpr int positions = 40;
        std::vector<Vec2> const polygon = polygon_of(tooth_, (tooth_.addendum + tooth_.dedendum) * 0x1p-10);
        for (int i = 0; i <= positions; ++i)
        {
            Pose const pose = motion_.pose(motion_.half_lobe() * (2.0 * i / positions - 1));
            std::vector<Vec2> placed;
            placed.reserve(polygon.size());
            for (Vec2 const& p : polygon)
                placed.push_back(pose(p));
            out_.tooth_family.push_back(std::move(placed));
        }
    }

    Solution& out_;
    Profile const& tooth_;
    Motion const& motion_;
    StageClock& clock_;
    Envelope<Motion> base_;
    double pitch_;
    Tolerance tolerance_;
    std::vector<Branch> branches_;
    std::vector<Branch> moved_branches_;
    std::optional<Envelope<Motion>> moved_;   ///< of the tooth with the side clearance on it
    TracedSpace final_;
    std::optional<CentredOutlineSampler<Motion>> sampler_;   ///< of the boundary in final_
    CentredOutline outline_;
    bool records_wanted_ = false;   ///< points of the branches themselves, which the boundary does without
};

}  // namespace hdconj::detail
