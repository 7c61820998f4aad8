// SPDX-License-Identifier: GPL-3.0-or-later
#include "conjugate_solver.hpp"

#include <cstddef>
#include <numbers>
#include <utility>

#include "boundary_checks.hpp"
#include "conjugate/chord_moved.hpp"
#include "drive/drive.hpp"
#include "flank_contact.hpp"
#include "hdconj/error.hpp"
#include "outline_records.hpp"
#include "records_beside.hpp"
#include "root_clearance.hpp"

namespace hdconj::conjugate {
namespace {

/// What the teeth of @p envelope leave of the ring outside its tip circle, from polygons of the chord error @p chord
/// [mm]. Segments are counted in @p out.
TracedSpace traced_space(envelope::AnyEnvelope const& envelope, std::vector<envelope::Branch> const& branches,
                         double chord, Tolerance const& tolerance, Solution& out)
{
    TracedSpace traced;
    traced.arcs = all_arcs(branches);
    traced.space = ToothSpaceFinder<motion::AnyMotion>(envelope, traced.arcs, out.geometry.circular_spline_inner_radius,
                                                       out.scene.drive.circular_spline_teeth, tolerance, chord)();
    out.work.arrangement_edges += traced.space.segments;
    return traced;
}

}  // namespace

ConjugateSolver::ConjugateSolver(Solution& out, profile::Profile const& tooth, motion::AnyMotion const& motion,
                                 drive::StageClock& clock)
    : out_(out),
      tooth_(tooth),
      motion_(motion),
      clock_(clock),
      base_(tooth, motion, 0),
      pitch_(2 * std::numbers::pi / out.scene.drive.circular_spline_teeth),
      tolerance_{out.scene.solver.tolerance, out.geometry.r_m + out.geometry.w0 + tooth.pitch_line + tooth.addendum}
{
}

void ConjugateSolver::operator()(profile::Profile const& given)
{
    shown_.emplace(given, tolerance_.length, out_.flexspline_outline);
    find_branches_of_tooth();
    find_boundary();
    clock_.run(Stage::outline, [&] { publish(); });
}

void ConjugateSolver::find_boundary()
{
    if (is_moved())
        clock_.run_rest(Stage::backlash, [&] { (void)moved_branches(); });
    auto const wanted = [&] {
        return out_.scene.circular_spline.backlash_offset - tolerance_.coincidence() - 2 * final_.space.gap;
    };
    assemble_until_clear(
        out_, first_chord(), [&](double c) { assemble(c); }, wanted, "");
}

double ConjugateSolver::pointed_radius(double tip)
{
    std::vector<envelope::ContactArc> const arcs = all_arcs(is_moved() ? moved_branches() : branches_);
    return swept_polygons(final_envelope(), arcs, tip, pitch_, first_chord(), false).radius_between_spaces();
}

ToothSpaceBoundary ConjugateSolver::curve(std::shared_ptr<profile::Profile const> tooth) const
{
    Halves const halves = cut_at_centre_line(final_envelope(), final_.arcs, final_.space.pieces, pitch_, tolerance_);
    std::vector<BoundaryPiece> pieces = halves.left;
    pieces.insert(pieces.end(), halves.right.begin(), halves.right.end());
    return {std::move(tooth),
            motion_,
            final_envelope().offset(),
            final_.arcs,
            std::move(pieces),
            out_.geometry.circular_spline_inner_radius,
            pitch_};
}

envelope::AnyEnvelope ConjugateSolver::final_envelope() const
{
    return {tooth_, motion_, out_.scene.circular_spline.backlash_offset};
}

void ConjugateSolver::find_branches_of_tooth()
{
    clock_.run(Stage::envelope, [&] {
        bool const long_job = tooth_.pieces.size() > branches_worth_a_thread(base_, tolerance_.length);
        envelope::BranchSet set = envelope::find_branches(base_, out_.threads, long_job);
        refuse_lost_branches(set.record, tolerance_.length);
        record_doubts(set.record, tooth_, out_.certificate);
        branches_ = std::move(set.branches);
        out_.work.roots_isolated += set.record.roots;
        out_.work.envelope_points += set.record.evaluations;
    });
}

std::vector<envelope::Branch> const& ConjugateSolver::moved_branches()
{
    if (!moved_branches_) {
        envelope::BranchSet set = envelope::find_branches(final_envelope(), out_.threads);
        refuse_lost_branches(set.record, tolerance_.length);
        moved_branches_ = std::move(set.branches);
    }
    return *moved_branches_;
}

void ConjugateSolver::find_pieces(double chord, DeferredTasks& jobs)
{
    try {
        trace_boundary(chord);
        std::vector<double> chords;
        for (std::size_t i = 0; i < sampler_->pieces().count(); ++i)
            chords.push_back(sampler_->pieces().expected(i));
        jobs.open(chords.size(),
                  [this, order = largest_first(chords)](std::size_t k) { sampler_->pieces().sample(order[k], 1); });
    } catch (...) {
        jobs.close();
        throw;
    }
    jobs.help();
}

void ConjugateSolver::assemble(double chord)
{
    clock_.run_rest(Stage::outline, [&] {
        if (auto const shown = std::exchange(shown_, std::nullopt))
            // one thread arranges the boundary's polygons, the others take branches meanwhile, and then pieces of
            // the outline with it
            out_.branches = records_beside(base_, branches_, tolerance_.length, out_.threads, out_.work.envelope_points,
                                           *shown, [&](DeferredTasks& jobs) { find_pieces(chord, jobs); });
        else {
            trace_boundary(chord);
            sample_pieces();
        }
        join_pieces();
        double const shift = conjugate::largest_radial_shift(out_.scene);
        for (conjugate::MovedChord moved(tolerance_.length);
             shift > 0 && moved.is_longer(conjugate::chord_moved_radially(outline_.outline.points,
                                                                          outline_.outline.chord, shift));) {
            find_sampler(moved.asked());
            sample_pieces();
            join_pieces();
        }
    });
    clock_.run(Stage::root_clearance, [&] {
        std::size_t const before = outline_.outline.points.size();
        deepen(outline_.outline, outline_.middle, out_.scene.circular_spline.root_clearance);
        outline_.middle += (outline_.outline.points.size() - before) / 2;
    });
    clock_.run(Stage::interference, [&] { check(); });
}

void ConjugateSolver::trace_boundary(double chord)
{
    clock_.run(Stage::region, [&] {
        try {
            final_ = traced_space(base_, branches_, chord, tolerance_, out_);
        } catch (NumericalError const& error) {
            if (error.code() == ErrorCode::no_land && is_moved())  // moved flanks meet further out: that is to be told
                (void)traced_space(final_envelope(), moved_branches(), chord, tolerance_, out_);
            throw;
        }
    });
    clock_.run(Stage::backlash, [&] {
        TracedSpace shifted = traced_space(final_envelope(), moved_branches(), chord, tolerance_, out_);
        require_same_topology(base_, final_.arcs, final_.space, shifted.arcs, shifted.space, pitch_,
                              out_.scene.circular_spline.backlash_offset, tolerance_.length);
        final_ = std::move(shifted);
    });
    clock_.run(Stage::outline, [&] {
        if (is_moved())
            moved_.emplace(final_envelope());
        find_sampler(tolerance_.length);
    });
}

void ConjugateSolver::find_sampler(double chord)
{
    sampler_.emplace(moved_ ? *moved_ : base_, final_.arcs, final_.space.pieces,
                     out_.geometry.circular_spline_inner_radius, pitch_, tolerance_, chord);
}

void ConjugateSolver::sample_pieces()
{
    for (std::size_t i = 0; i < sampler_->pieces().count(); ++i)
        sampler_->pieces().sample(i, out_.threads);
}

void ConjugateSolver::join_pieces()
{
    outline_ = sampler_->joined();
    out_.work.envelope_points += outline_.outline.evaluations;
}

void ConjugateSolver::check()
{
    distance::FullTurnClearance<motion::AnyMotion> const clearance(tooth_, motion_, pitch_,
                                                                   drive::pitches_per_lobe(out_.scene));
    std::size_t const first = tooth_.mirror_symmetric && motion_.symmetric() ? outline_.middle : 0;
    out_.check =
        check_turn(clearance, motion_, outline_.outline.points, points_to_check(outline_.outline, first), out_.threads);
}

void ConjugateSolver::publish()
{
    Outline const& outline = outline_.outline;
    CircularSplineOutline& cs = out_.circular_spline;
    cs.z = {0.0};
    cs.pieces = piece_records(outline, tooth_);
    Bottom const bottom = bottom_of(outline, outline_.middle);
    std::size_t const left_land = outline.stretches.front().last;
    std::size_t const right_land = outline.stretches.back().first;
    for (std::size_t index : {left_land, bottom.first, outline_.middle, bottom.last, right_land})
        cs.landmarks.push_back(static_cast<int>(index));
    measure_space(outline, left_land, right_land, pitch_, out_.geometry, out_.error);
    cs.outline.push_back(
        outline.points);  // a copy: what was grown in the midst of other work keeps pages that a file needs next
    out_.error.chord = outline.chord;
    out_.error.point = outline.error + final_.space.gap;
    out_.error.clearance = out_.error.point + tolerance_.roundoff();
    for (std::size_t i = 0; i < branches_.size(); ++i)
        append_zones(base_, branches_[i], i, final_.arcs, final_.space.pieces, out_);
    FlankContactSum touching;
    touching.add(moved_ ? *moved_ : base_, final_.arcs, final_.space.pieces,
                 [tip = out_.geometry.circular_spline_inner_radius](Vec2 const& p) { return p.norm() > tip; });
    out_.flank_contact = touching.value();
    add_positions(tooth_, motion_, 0, out_.tooth_family);
}

}  // namespace hdconj::conjugate
