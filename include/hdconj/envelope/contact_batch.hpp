// SPDX-License-Identifier: GPL-3.0-or-later
// Envelope points of one arc, corner or line at many positions at once, with all that Envelope::point() gives.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <variant>

#include "hdconj/envelope/envelope.hpp"
#include "hdconj/motion/cosine_form.hpp"

namespace hdconj::envelope {

/// phi at every @p u, into @p phi of the same length. Domain: |waves u| <= 64. Accuracy: that of NeutralCurve::phi(),
/// 2^-51 of the angle.
void undeformed_angles(motion::CosineForm const& motion, std::span<double const> u, std::span<double> phi);

/// Envelope::point() of a contact on an arc, corner or line, many at once. The loops have no branches, so that a
/// compiler makes vector instructions of them. Which ones is chosen when the program is loaded; all give the same bits.
/// No point depends on its neighbours: any other split into calls gives the same bits.
///
/// Domain: |waves u| <= 64. Ends that are given are not taken for the solved ones: see point_batch(). Degenerate: where
/// the closed form has no value, or the normal is more than a quarter turn from the arc's middle, t is not a number.
/// Accuracy: as Envelope::point(), whose error estimate is repeated; the two differ by some roundings of the
/// coordinates.
class ContactBatch
{
  public:
    /// @param shape   an arc or a line
    /// @param side    sign of the normal, ContactArc::candidate; of a line not used
    /// @param offset  side clearance [mm]
    ContactBatch(motion::CosineForm const& motion, profile::PieceShape const& shape, int side, double offset);

    /// Points at every @p u, into @p points of the same length.
    void operator()(std::span<double const> u, std::span<EnvelopePoint> points) const;

    /// The numbers of the loops.
    struct Numbers
    {
        motion::CosineForm motion;
        double a_x, a_y;  ///< centre, or start of the line
        double n_x, n_y;  ///< middle normal of the arc, normal of the line
        double t_x, t_y;  ///< tangent of the line
        double radius;    ///< with offset; of a line the offset
        double side;
        double span;  ///< angle of the arc, length of the line
        double size;  ///< distance of the centre from the tooth's origin
    };

  private:
    Numbers numbers_;
    bool line_;
};

/// The batch for @p arc; nothing where its piece, the contact or the motion has no closed form of that kind.
template <motion::RelativeMotion Motion>
[[nodiscard]] std::optional<ContactBatch> contact_batch(Envelope<Motion> const& envelope, ContactArc const& arc)
{
    if (arc.resting || std::holds_alternative<profile::CurvePiece>(envelope.shape(arc)))
        return std::nullopt;
    std::optional<motion::CosineForm> const form = motion::cosine_form(envelope.motion());
    if (!form)
        return std::nullopt;
    return ContactBatch(*form, envelope.shape(arc), arc.candidate, envelope.offset());
}

/// Points of @p arc at every @p u; at its ends, and where rounding carries a contact over the end of its piece, those
/// of Envelope::point().
template <motion::RelativeMotion Motion>
void point_batch(Envelope<Motion> const& envelope, ContactArc const& arc, ContactBatch const& batch,
                 std::span<double const> u, std::span<EnvelopePoint> points)
{
    batch(u, points);
    for (std::size_t i = 0; i < u.size(); ++i)
        if (!(points[i].t >= 0 && points[i].t <= 1) || u[i] == arc.u_begin || u[i] == arc.u_end)
            points[i] = envelope.point(arc, u[i]);
}

}  // namespace hdconj::envelope
