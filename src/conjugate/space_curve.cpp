// SPDX-License-Identifier: GPL-3.0-or-later
#include "space_curve.hpp"

#include <cmath>

namespace hdconj::conjugate {

CurvePoint ToothSpaceBoundary::at(BoundaryPiece const& piece, double u) const
{
    if (piece.arc < 0) {
        Vec2 const out{std::sin(u), std::cos(u)};
        return {tip_radius_ * out, out};
    }
    envelope::EnvelopePoint const e = turned(piece).point(u);
    return {e.p, e.n};
}

double ToothSpaceBoundary::profile_parameter(BoundaryPiece const& piece, double u) const
{
    envelope::ContactArc const& contacts = arc(piece);
    profile::ProfilePiece const& origin = tooth_->pieces[static_cast<std::size_t>(contacts.piece)];
    return origin.t_begin + envelope_.point(contacts, u).t * (origin.t_end - origin.t_begin);
}

envelope::SampledArc ToothSpaceBoundary::sampled(BoundaryPiece const& piece, double chord) const
{
    envelope::SampledArc result;
    if (piece.arc >= 0) {
        result = envelope::sample_arc(envelope_, arc(piece), piece.begin, piece.end, chord, 1);
        for (envelope::EnvelopePoint& e : result.points) {
            CurvePoint const c = at(piece, e.u);
            e.p = c.p;
            e.n = c.n;
        }
        return result;
    }
    auto const count = static_cast<int>(land_chords(tip_radius_, piece.begin, piece.end, chord));
    for (int k = 0; k <= count; ++k) {
        double const angle = k == count ? piece.end : piece.begin + (piece.end - piece.begin) * k / count;
        CurvePoint const c = at(piece, angle);
        result.points.push_back({angle, 0, c.p, c.n, 0});
    }
    result.chord = tip_radius_ * (1 - std::cos(0.5 * (piece.end - piece.begin) / count));
    return result;
}

}  // namespace hdconj::conjugate
