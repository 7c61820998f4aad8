// SPDX-License-Identifier: GPL-3.0-or-later
// Outlines where the circular spline's tooth is given: of that one, and of the flexspline tooth that it leaves.
#pragma once

#include <vector>

#include "centred_outline.hpp"
#include "conjugate/outline.hpp"
#include "hdconj/conjugate/tooth_body.hpp"
#include "hdconj/motion/any_motion.hpp"
#include "hdconj/solution.hpp"

namespace hdconj::conjugate {

/// One pitch of the circular spline with the given tooth: from the middle of one tooth's tip across the space to that
/// of the next. Between the roots the bottom of the space is a circle about the drive's axis.
/// @param radius  of the origin of the tooth's frame
/// @param chord   largest chord error [mm]
[[nodiscard]] CentredOutline given_spline(profile::Profile const& tooth, double radius, double pitch, double chord);

/// Writes it into @p out as its one slice, with its landmarks and measures.
void publish_given_spline(Solution& out, profile::Profile const& tooth, CentredOutline const& spline, double pitch);

using Swept = SweptTooth<motion::AnyMotion>;  ///< of a circular-spline tooth as the flexspline tooth sees it

/// Samples the flanks of a tooth to the tolerance and goes on below them to the root, in the frame of the tooth: from
/// the left root to the right root.
class FlexsplineOutline
{
  public:
    /// @param given      the circular spline's tooth
    /// @param teeth      what bounds the tooth: pieces of the body name them by their index
    /// @param symmetric  the left flank is the mirror image of the right one
    FlexsplineOutline(profile::Profile const& given, std::vector<Swept> const& teeth, BodyLimits const& limits,
                      Tolerance tolerance, bool symmetric, int threads)
        : given_(given), teeth_(teeth), limits_(limits), tolerance_(tolerance), symmetric_(symmetric), threads_(threads)
    {
    }

    /// @throws NumericalError where the flanks reach below the root
    [[nodiscard]] Outline operator()(ToothBody const& body) const;

  private:
    /// A flank from one end to the other; neighbouring pieces of one tooth are sampled together.
    [[nodiscard]] Outline flank(std::vector<BoundaryPiece> const& pieces) const;
    /// Below its foot nothing touches the tooth. It goes on straight to the root and leaves half of what is left of the
    /// pitch to the space between two roots, outward by 45 degrees at most: what the tips sweep is all but level there.
    [[nodiscard]] Vec2 root_below(Vec2 const& foot) const;

    profile::Profile const& given_;
    std::vector<Swept> const& teeth_;
    BodyLimits const& limits_;
    Tolerance tolerance_;
    bool symmetric_;
    int threads_;
};

}  // namespace hdconj::conjugate
