// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <deque>
#include <iterator>
#include <numbers>
#include <numeric>
#include <utility>

#include "boundary_checks.hpp"
#include "conjugate_solver.hpp"
#include "drive/drive.hpp"
#include "flank_contact.hpp"
#include "hdconj/base/parallel.hpp"
#include "outline_records.hpp"
#include "records_beside.hpp"
#include "reverse_outlines.hpp"

namespace hdconj::conjugate {
namespace {

/// The branches of one circular-spline tooth.
struct Traced
{
    int number = 0;  ///< 0 and 1 stand on the sides of the space that the flexspline tooth enters
    std::vector<envelope::Branch> branches;
};

/// The pieces of both flanks that the tooth of index @p copy bounds.
[[nodiscard]] std::vector<BoundaryPiece> pieces_of(ToothBody const& body, int copy)
{
    std::vector<BoundaryPiece> own;
    for (auto const* flank : {&body.left, &body.right})
        std::copy_if(flank->begin(), flank->end(), std::back_inserter(own),
                     [copy](BoundaryPiece const& p) { return p.copy == copy; });
    return own;
}

class ReverseJob
{
  public:
    ReverseJob(Solution& out, profile::Profile const& given, motion::AnyMotion const& motion, drive::StageClock& clock)
        : out_(out),
          given_(given),
          motion_(motion),
          clock_(clock),
          pitch_(2 * std::numbers::pi / out.scene.drive.circular_spline_teeth),
          seat_radius_(drive::given_tooth_seat(out.geometry, given)),
          tolerance_{out.scene.solver.tolerance, seat_radius_}
    {
        PairGeometry const& g = out.geometry;
        limits_.tip = g.pitch_line + g.addendum;
        limits_.root = g.pitch_line - g.dedendum;
        limits_.addendum = g.addendum;
        limits_.half_width = std::numbers::pi / out.scene.drive.flexspline_teeth * (g.r_m + limits_.root);
        // the teeth that pass the flexspline tooth's centre line in a lobe; that others do not matter shows in the
        // check
        int const beside = (drive::pitches_per_lobe(out.scene) - 1) / 2;
        for (int k = -beside; k <= 1 + beside; ++k) {
            motions_.push_back(motion::seen_from_flexspline(motion, k, pitch_, seat_radius_));
            traced_.push_back({k, {}});
        }
    }

    void operator()()
    {
        clock_.run(Stage::envelope, [&] { trace(); });
        double const chord = (given_.addendum + given_.dedendum) * 0x1p-12;
        auto const wanted = [&] {
            return out_.scene.circular_spline.backlash_offset - tolerance_.coincidence() - 2 * body_.gap;
        };
        assemble_until_clear(
            out_, chord, [&](double c) { assemble(c); }, wanted, " of the flexspline tooth, y from the pitch line");
        clock_.run(Stage::outline, [&] { publish(); });
    }

  private:
    [[nodiscard]] std::vector<envelope::Branch> branches_at(envelope::AnyEnvelope const& envelope, bool counted)
    {
        envelope::BranchSet set = envelope::find_branches(envelope, out_.threads);
        refuse_lost_branches(set.record, tolerance_.length);
        if (counted) {
            record_doubts(set.record, given_, out_.certificate);
            out_.work.roots_isolated += set.record.roots;
            out_.work.envelope_points += set.record.evaluations;
        }
        return std::move(set.branches);
    }

    void trace()
    {
        base_.clear();
        for (std::size_t j = 0; j < traced_.size(); ++j) {
            envelope::AnyEnvelope const envelope(given_, motions_[j], 0);
            traced_[j].branches = branches_at(envelope, true);
            base_.push_back({envelope, all_arcs(traced_[j].branches)});
        }
        record_branches();
    }

    void record_branches()
    {
        struct Job
        {
            std::size_t tooth;
            envelope::Branch const* branch;
        };
        std::vector<Job> jobs;
        for (std::size_t j = 0; j < traced_.size(); ++j)
            for (envelope::Branch const& branch : traced_[j].branches)
                jobs.push_back({j, &branch});
        std::vector<BranchRecord> records(jobs.size());
        std::vector<std::size_t> evaluations(jobs.size(), 0);
        parallel_for(jobs.size(), out_.threads, branches_worth_a_thread(base_.front().envelope, tolerance_.length),
                     [&](std::size_t i) {
                         records[i] = branch_record(base_[jobs[i].tooth].envelope, *jobs[i].branch, tolerance_.length,
                                                    evaluations[i]);
                         records[i].tooth = traced_[jobs[i].tooth].number;
                         for (Vec2& p : records[i].point)
                             p.y() -= out_.geometry.pitch_line;
                     });
        out_.work.envelope_points += std::accumulate(evaluations.begin(), evaluations.end(), std::size_t{0});
        out_.branches.insert(out_.branches.end(), std::make_move_iterator(records.begin()),
                             std::make_move_iterator(records.end()));
    }

    /// Region, backlash, outline and check, with polygons of the given chord error.
    void assemble(double chord)
    {
        double const offset = out_.scene.circular_spline.backlash_offset;
        clock_.run(Stage::region, [&] {
            body_ = body_of(base_, chord);
            final_ = base_;
        });
        clock_.run(Stage::backlash, [&] {
            std::vector<Swept> moved;
            for (motion::AnyMotion const& motion : motions_) {
                envelope::AnyEnvelope const envelope(given_, motion, offset);
                moved.push_back({envelope, all_arcs(branches_at(envelope, false))});
            }
            ToothBody const shifted = body_of(moved, chord);
            refuse_lost(shifted, moved, offset);
            body_ = shifted;
            final_ = std::move(moved);
        });
        clock_.run(Stage::outline, [&] {
            tooth_ = FlexsplineOutline(given_, final_, limits_, tolerance_, symmetric(), out_.threads)(body_);
            out_.work.envelope_points += tooth_.evaluations;
        });
        clock_.run(Stage::interference, [&] {
            distance::ReverseFullTurnClearance<motion::AnyMotion> const clearance(given_, motion_, pitch_, seat_radius_,
                                                                                  drive::pitches_per_lobe(out_.scene));
            std::vector<Vec2> points = tooth_.points;
            std::vector<std::size_t> chosen = points_to_check(tooth_, symmetric() ? tip_land_end() : 0);
            // the walls are long and have no points of their own
            constexpr int stations = 8;
            for (std::size_t const end : {std::size_t{1}, points.size() - 1}) {
                for (int i = 1; i < stations; ++i) {
                    chosen.push_back(points.size());
                    points.push_back(tooth_.points[end - 1] +
                                     (tooth_.points[end] - tooth_.points[end - 1]) * i / stations);
                }
            }
            out_.check = check_turn(clearance, motion_, points, chosen, out_.threads);
            out_.check->where.y() -= out_.geometry.pitch_line;
        });
    }

    [[nodiscard]] ToothBody body_of(std::vector<Swept> const& teeth, double chord)
    {
        ToothBody body = ToothBodyFinder<motion::AnyMotion>(teeth, limits_, tolerance_, chord)();
        out_.work.arrangement_edges += body.segments;
        return body;
    }

    /// Stretches at the tip and at the foot are cut there and may move away; between them none may vanish.
    void refuse_lost(ToothBody const& shifted, std::vector<Swept> const& moved, double offset) const
    {
        auto const arc_of = [](std::vector<Swept> const& teeth, BoundaryPiece const& p) -> envelope::ContactArc const& {
            return teeth[static_cast<std::size_t>(p.copy)].arcs[static_cast<std::size_t>(p.arc)];
        };
        auto const goes_on = [&](BoundaryPiece const& a, BoundaryPiece const& b) {
            return outline_goes_on(given_, a, arc_of(base_, a), b, arc_of(base_, b));
        };
        auto const kept = [&](BoundaryPiece const& p) {
            return has_contact(pieces_of(shifted, p.copy), moved[static_cast<std::size_t>(p.copy)].arcs,
                               arc_of(base_, p), p.copy);
        };
        auto const point = [&](BoundaryPiece const& p, double u) {
            return base_[static_cast<std::size_t>(p.copy)].envelope.point(arc_of(base_, p), u).p;
        };
        for (auto const* flank : {&body_.left, &body_.right}) {
            if (flank->size() > 2)
                require_same_topology({flank->begin() + 1, flank->end() - 1}, goes_on, kept, point, offset,
                                      tolerance_.length);
        }
    }

    [[nodiscard]] bool symmetric() const { return given_.mirror_symmetric && motion_.symmetric(); }

    /// Index of the right end of the tip land.
    [[nodiscard]] std::size_t tip_land_end() const
    {
        auto const land = std::find_if(tooth_.stretches.begin(), tooth_.stretches.end(),
                                       [](OutlineStretch const& s) { return s.kind == OutlineKind::land; });
        return land->last;
    }

    void publish()
    {
        out_.flexspline_outline = tooth_.points;
        for (Vec2& p : out_.flexspline_outline)
            p.y() -= out_.geometry.pitch_line;
        out_.flexspline_outline.front().y() = out_.flexspline_outline.back().y() = -out_.geometry.dedendum;
        out_.flexspline_pieces = piece_records(tooth_, given_);
        CentredOutline const spline = given_spline(given_, seat_radius_, pitch_, tolerance_.length);
        publish_given_spline(out_, given_, spline, pitch_);
        out_.error.chord = std::max(tooth_.chord, spline.outline.chord);
        out_.error.point = std::max(tooth_.error, spline.outline.error) + body_.gap;
        out_.error.clearance = out_.error.point + tolerance_.roundoff();
        std::size_t index = 0;
        FlankContactSum touching;
        for (std::size_t j = 0; j < traced_.size(); ++j) {
            std::vector<BoundaryPiece> const own = pieces_of(body_, static_cast<int>(j));
            // the teeth beside that space touch other flexspline teeth where these two do not
            touching.add(final_[j].envelope, final_[j].arcs, own, [&](Vec2 const& p) {
                bool const beside = traced_[j].number == 0 || traced_[j].number == 1;
                return beside && p.y() > limits_.root && p.y() < limits_.tip && std::abs(p.x()) < limits_.half_width;
            });
            for (envelope::Branch const& branch : traced_[j].branches)
                append_zones(base_[j].envelope, branch, index++, final_[j].arcs, own, out_);
        }
        out_.flank_contact = touching.value();
        for (motion::AnyMotion const& motion : motions_)
            add_positions(given_, motion, out_.geometry.pitch_line, out_.tooth_family);
    }

    Solution& out_;
    profile::Profile const& given_;
    motion::AnyMotion motion_;
    drive::StageClock& clock_;
    double pitch_;
    double seat_radius_;
    Tolerance tolerance_;
    BodyLimits limits_;
    std::deque<motion::AnyMotion> motions_;  // envelopes keep pointers to them
    std::vector<Traced> traced_;
    std::vector<Swept> base_;
    std::vector<Swept> final_;
    ToothBody body_;
    Outline tooth_;
};

}  // namespace

void solve_reverse(Solution& out, profile::Profile const& given, motion::AnyMotion const& motion,
                   drive::StageClock& clock)
{
    ReverseJob(out, given, motion, clock)();
}

}  // namespace hdconj::conjugate
