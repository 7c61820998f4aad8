// SPDX-License-Identifier: GPL-3.0-or-later
#include "space_curve.hpp"

#include <algorithm>
#include <cmath>

#include "hdconj/numeric/bracketed_root.hpp"

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

ToothSpaceBoundary ToothSpaceBoundary::cut_at(double tip) const
{
    auto const above = [&](BoundaryPiece const& piece, double u) { return at(piece, u).p.norm() - tip; };
    std::size_t const last = pieces_.size() - 1;
    // the flank that leads to the bottom crosses the circle upwards for the last time, the other one then comes down
    std::size_t left = 0, right = last;
    for (std::size_t i = 1; i < right; ++i) {
        bool const begins_above = above(pieces_[i], pieces_[i].begin) >= 0;
        bool const ends_above = above(pieces_[i], pieces_[i].end) >= 0;
        if (!begins_above && ends_above)
            left = i;
        if (begins_above && !ends_above && left > 0)
            right = i;
    }
    if (left == 0 || right == last)
        return *this;
    std::vector<BoundaryPiece> kept(pieces_.begin() + static_cast<std::ptrdiff_t>(left - 1),
                                    pieces_.begin() + static_cast<std::ptrdiff_t>(right + 2));
    auto const crossing = [&](BoundaryPiece const& piece) {
        auto const height = [&](double u) { return above(piece, u); };
        return numeric::bracketed_root(height, std::min(piece.begin, piece.end), std::max(piece.begin, piece.end)).x;
    };
    auto const angle_at = [](Vec2 const& p) { return std::atan2(p.x(), p.y()); };
    BoundaryPiece &first = kept[1], &final = kept[kept.size() - 2];
    first.begin = crossing(first);
    final.end = crossing(final);
    kept.front() = pieces_.front();
    kept.front().end = angle_at(at(first, first.begin).p);
    kept.back() = pieces_.back();
    kept.back().begin = angle_at(at(final, final.end).p);
    return {tooth_, *motion_, offset(), arcs_, std::move(kept), tip, pitch_};
}

}  // namespace hdconj::conjugate
