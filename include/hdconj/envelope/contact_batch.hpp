// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Envelope points of one arc, corner or line at many positions at once, with all that Envelope::point() gives.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <variant>

#include "hdconj/envelope/envelope.hpp"

namespace hdconj::envelope {

/// The exact motion of a cosine cam, as the numbers that its closed form is made of.
struct BatchMotion
{
    /// Harmonics of the arc length that are summed; type-50 has four above rounding.
    static constexpr std::size_t harmonics = 8;

    double w0, waves, r_0, r_m, ratio;
    double mean;                          ///< of the line element
    std::array<double, harmonics> sines;  ///< r_m phi = mean u + sum of sines[k - 1] sin(k n u)
};

/// Nothing where the motion has no such form: another model or wave generator, or more harmonics.
template <motion::RelativeMotion Motion>
[[nodiscard]] std::optional<BatchMotion> batch_motion(Motion const& motion)
{
    if constexpr (requires { motion.curve().shape().as_cosine(); }) {
        auto const cam = motion.curve().shape().as_cosine();
        auto const* series = motion.curve().length().series();
        if (!cam || series == nullptr)
            return std::nullopt;
        for (std::size_t k = BatchMotion::harmonics + 1; k < series->terms(); ++k)
            if (std::abs(series->cosine(k)) > series->noise())
                return std::nullopt;
        double const waves = cam->n;
        BatchMotion result{cam->w0,        waves, motion.curve().r_0(), motion.curve().r_m(), motion.tooth_ratio(),
                           series->mean(), {}};
        for (std::size_t k = 1; k <= BatchMotion::harmonics; ++k) {
            if (series->sine(k) != 0)
                return std::nullopt;
            result.sines[k - 1] = series->cosine(k) / (static_cast<double>(k) * waves);
        }
        return result;
    } else {
        return std::nullopt;
    }
}

/// phi at every @p u, into @p phi of the same length. Domain: |waves u| <= 64. Accuracy: that of NeutralCurve::phi(),
/// 2^-51 of the angle.
void undeformed_angles(BatchMotion const& motion, std::span<double const> u, std::span<double> phi);

/// Envelope::point() of a contact on an arc, corner or line, in loops without branches of which a compiler makes vector
/// instructions; which ones is chosen when the program is loaded, with the same bits for all. No point depends on its
/// neighbours: the bits are those of any other split into calls.
///
/// Domain: |waves u| <= 64. Ends that are given are not taken for the solved ones: see point_batch().
/// Degenerate: where the closed form has no value, or the normal is more than a quarter turn from the arc's middle, t
/// is not a number. Accuracy: as Envelope::point(), whose error estimate is repeated; the two differ by some roundings
/// of the coordinates.
class ContactBatch
{
  public:
    /// @param shape   an arc or a line
    /// @param side    sign of the normal, ContactArc::candidate; of a line not used
    /// @param offset  side clearance [mm]
    ContactBatch(BatchMotion const& motion, profile::PieceShape const& shape, int side, double offset);

    /// Points at every @p u, into @p points of the same length.
    void operator()(std::span<double const> u, std::span<EnvelopePoint> points) const;

    /// The numbers of the loops.
    struct Numbers
    {
        BatchMotion motion;
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
    profile::PieceShape const& shape = envelope.profile().pieces[static_cast<std::size_t>(arc.piece)].shape;
    if (arc.resting || std::holds_alternative<profile::CurvePiece>(shape))
        return std::nullopt;
    std::optional<BatchMotion> const motion = batch_motion(envelope.motion());
    if (!motion)
        return std::nullopt;
    return ContactBatch(*motion, shape, arc.candidate, envelope.offset());
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
