// SPDX-License-Identifier: GPL-3.0-or-later
// The envelope of one tooth under its motion, at an offset: contacts at any instant, and points of the envelope.
#pragma once

#include <variant>

#include "hdconj/envelope/branch.hpp"
#include "hdconj/envelope/contact.hpp"
#include "hdconj/profile/profile.hpp"

namespace hdconj::envelope {

/// A point of the envelope in the circular-spline frame.
struct EnvelopePoint
{
    double u = 0;
    double t = 0;           ///< local piece parameter
    Vec2 p = Vec2::Zero();  ///< [mm]
    Vec2 n = Vec2::Zero();  ///< outward normal of the swept region's side that touches here
    double error = 0;       ///< estimated rounding error of p, along the curve [mm]
};

/// Profile and motion together, with the parallel offset of the envelope.
///
/// The envelope of the tooth offset by d is the offset of its envelope. The condition n.v = 0 holds at the same
/// instants, since the turn omega x (d n) has no part along n.
template <motion::RelativeMotion Motion>
class Envelope
{
  public:
    Envelope(profile::Profile const& profile, Motion const& motion, double offset)
        : profile_(&profile), motion_(&motion), offset_(offset)
    {
    }

    [[nodiscard]] profile::Profile const& profile() const { return *profile_; }
    [[nodiscard]] Motion const& motion() const { return *motion_; }
    [[nodiscard]] double offset() const { return offset_; }

    /// Shape of the profile piece that @p arc is on.
    [[nodiscard]] profile::PieceShape const& shape(ContactArc const& arc) const
    {
        return profile_->pieces[static_cast<std::size_t>(arc.piece)].shape;
    }

    /// Contact followed by @p arc at @p u.
    [[nodiscard]] Contact contact(ContactArc const& arc, double u) const
    {
        return arc.resting ? resting_contact(std::get<profile::ArcPiece>(shape(arc)), arc, u, offset_)
                           : contact(arc, u, motion_->rates(u));
    }

    /// The same where the rates at @p u are known.
    [[nodiscard]] Contact contact(ContactArc const& arc, double u, motion::MotionRates const& rates) const
    {
        if (auto const* circle = std::get_if<profile::ArcPiece>(&shape(arc)))
            return arc_contact(*circle, rates, arc.candidate, offset_);
        if (auto const* line = std::get_if<profile::LinePiece>(&shape(arc)))
            return line_contact(*line, rates, offset_);
        auto const& curve = std::get<profile::CurvePiece>(shape(arc));
        return curve_contact(curve, rates, followed_root(curve, rates.twist, arc, u), offset_);
    }

    /// Envelope point followed by @p arc at @p u. Where the arc begins or ends with an end of its piece this is that
    /// end's path, so that neighbouring pieces meet however fast their contacts run.
    [[nodiscard]] EnvelopePoint point(ContactArc const& arc, double u) const
    {
        if (u == arc.u_begin && is_end(arc.t_begin))
            return end_point(arc, u, arc.t_begin);
        if (u == arc.u_end && is_end(arc.t_end))
            return end_point(arc, u, arc.t_end);
        motion::MotionState const state = motion::state_of(*motion_, u);
        Contact const c = arc.resting ? contact(arc, u) : contact(arc, u, state.rates);
        double const doubt = roundings * unit_roundoff * c.rounding;
        // a contact that runs fast is uncertain along the profile: rounding must not carry it over the end
        if (!(c.t >= 0 && c.t <= 1) && near_end(arc, c, doubt))
            return end_point(arc, u, c.t > 0.5 ? 1.0 : 0.0);
        Pose const& pose = state.pose;
        Vec2 const p = pose(c.x);
        return {u, c.t, p, pose.rotate(c.n), roundings * unit_roundoff * p.norm() + doubt};
    }

    /// How far @p e may be from the true curve [mm]. Where the contact runs fast along a curve, as where two merge, the
    /// point is uncertain along it. But tooth and envelope touch there. A point of the tooth at the distance s along it
    /// is off the envelope by s^2 times half the difference of their curvatures. Twice the sum of both is taken.
    [[nodiscard]] double off_curve(ContactArc const& arc, EnvelopePoint const& e) const
    {
        double const fixed = roundings * unit_roundoff * e.p.norm();
        double const doubt = e.error - fixed;
        auto const* curve = std::get_if<profile::CurvePiece>(&shape(arc));
        if (curve == nullptr || !(doubt > fixed))
            return e.error;
        motion::MotionRates const rates = motion_->rates(e.u);
        Contact const c = curve_contact(*curve, rates, e.t, offset_);
        Vec2 const x1 = curve->first(e.t);
        double const k = -cross(x1, curve->second(e.t)) / (x1.squaredNorm() * x1.norm());
        double const of_tooth = std::abs(k / (1 + k * offset_)),
                     of_envelope = std::abs((rates.twist.omega * c.slowness - k * c.turning) / c.advance);
        double const off = (of_tooth + of_envelope) * doubt * doubt;
        return off < doubt ? fixed + off : e.error;  // not where it is infinite or no number
    }

  private:
    static constexpr double roundings = 8;  ///< some in the pose, some in the meshing condition

    [[nodiscard]] static bool is_end(double t) { return t == 0 || t == 1; }

    [[nodiscard]] profile::PieceEnd end_of_piece(ContactArc const& arc, double t) const
    {
        return t == 0 ? profile::start_of(shape(arc)) : profile::end_of(shape(arc));
    }

    [[nodiscard]] bool near_end(ContactArc const& arc, Contact const& c, double doubt) const
    {
        profile::PieceEnd const end = end_of_piece(arc, c.t > 0.5 ? 1 : 0);
        return (c.x - end.point - offset_ * end.normal).norm() <= doubt;
    }

    [[nodiscard]] EnvelopePoint end_point(ContactArc const& arc, double u, double t) const
    {
        profile::PieceEnd const end = end_of_piece(arc, t);
        Pose const pose = motion_->pose(u);
        Vec2 const p = pose(end.point + offset_ * end.normal);
        return {u, t, p, pose.rotate(end.normal), roundings * unit_roundoff * p.norm()};
    }

    /// The root that this arc follows. Roots keep their order between two critical u. Next to an end, where roundoff
    /// may add or drop a root, the one nearest to the chord between the known ends is taken. At an end that was solved
    /// for, the solved parameter holds: two contacts that merge have roots at the same u that are still the square root
    /// of roundoff apart.
    [[nodiscard]] double followed_root(profile::CurvePiece const& curve, PlanarVelocity const& twist,
                                       ContactArc const& arc, double u) const
    {
        auto const solved = [](BranchEnd end) {
            return end == BranchEnd::double_root || end == BranchEnd::segment_end;
        };
        if (u == arc.u_begin && solved(arc.begins))
            return arc.t_begin;
        if (u == arc.u_end && solved(arc.ends))
            return arc.t_end;
        numeric::BernsteinRoots const found = curve_contacts(curve, twist);
        if (found.count == arc.roots)
            return found.t[static_cast<std::size_t>(arc.candidate)];
        double const share = (u - arc.u_begin) / (arc.u_end - arc.u_begin);
        double const guess = arc.t_begin + share * (arc.t_end - arc.t_begin);
        double best = share < 0.5 ? arc.t_begin : arc.t_end;
        for (int i = 0; i < found.count; ++i) {
            double const t = found.t[static_cast<std::size_t>(i)];
            if (std::abs(t - guess) < std::abs(best - guess))
                best = t;
        }
        return best;
    }

    profile::Profile const* profile_;
    Motion const* motion_;
    double offset_;
};

/// A smooth parameter s in [0, 1] for an arc: u(s) is quadratic at an end where two contacts merge, so that the contact
/// moves there at finite speed.
[[nodiscard]] inline double arc_parameter_to_u(ContactArc const& arc, double s)
{
    bool const fold_begin = arc.begins == BranchEnd::double_root;
    bool const fold_end = arc.ends == BranchEnd::double_root;
    double share = s;
    if (fold_begin && fold_end)
        share = s * s * (3 - 2 * s);
    else if (fold_begin)
        share = s * s;
    else if (fold_end)
        share = s * (2 - s);
    // exact at both ends, monotone between
    return s >= 1 ? arc.u_end : arc.u_begin + share * (arc.u_end - arc.u_begin);
}

}  // namespace hdconj::envelope
