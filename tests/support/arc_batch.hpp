// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Envelope points of one arc at many positions at once, for sweeps that want nothing but points.
#pragma once

#include <span>

#include "hdconj/motion/exact_motion.hpp"
#include "hdconj/profile/pieces.hpp"
#include "hdconj/wavegen/cosine_cam.hpp"

namespace hdconj::envelope {

/// The closed form of arc_contact() and ExactMotion::pose() for the cosine cam, written without branches so that a
/// compiler makes vector instructions of it; the widest that the processor has are chosen at run time, with the same
/// bits whichever they are.
///
/// Domain: |u| <= 8 pi; no test whether the contact lies on the arc, no normal, no cusp test, no error estimate:
/// Envelope::point() has those. Degenerate: V = 0 (the whole arc touches) gives a point that is not finite. Accuracy:
/// some roundings of r_m across the envelope, as Envelope::point(); below 1e-12 mm on type-50, tested against it and 50
/// digits.
class ArcBatch
{
  public:
    /// @param side    sign of the normal, ContactArc::candidate
    /// @param offset  side clearance [mm]
    /// @throws NumericalError where the arc length needs more than `terms` harmonics for double precision
    ArcBatch(motion::ExactMotion<wavegen::CosineCam> const& motion, double tooth_ratio, profile::ArcPiece const& arc,
             int side, double offset);

    /// Points at every @p u; x, y of the same length.
    void operator()(std::span<double const> u, std::span<double> x, std::span<double> y) const;

    /// Harmonics of the arc length that are summed.
    static constexpr int terms = 8;

    /// The numbers of the loop.
    struct Numbers
    {
        double w0, waves, r_0, r_m, ratio;
        double centre_x, centre_y, radius;  ///< radius with side and offset
        double sines[terms];                ///< phi = u + sum of sines[k - 1] sin(k n u)
    };

  private:
    Numbers numbers_;
};

}  // namespace hdconj::envelope
