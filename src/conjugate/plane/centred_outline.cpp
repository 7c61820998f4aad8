// SPDX-License-Identifier: GPL-3.0-or-later
#include "centred_outline.hpp"

#include <algorithm>
#include <utility>

#include "hdconj/error.hpp"
#include "hdconj/numeric/bracketed_root.hpp"

namespace hdconj::conjugate {

OutlineSampler::OutlineSampler(envelope::AnyEnvelope const& envelope, std::vector<envelope::ContactArc> const& arcs,
                               std::vector<BoundaryPiece> pieces, double pitch, double chord)
    : envelope_(envelope),
      arcs_(arcs),
      pieces_(std::move(pieces)),
      pitch_(pitch),
      chord_(chord),
      sampled_(pieces_.size())
{
}

double OutlineSampler::expected(std::size_t i) const
{
    BoundaryPiece const& piece = pieces_[i];
    if (piece.arc < 0)
        return 0;
    envelope::ContactArc window = arc(piece);
    window.u_begin = std::min(piece.begin, piece.end);
    window.u_end = std::max(piece.begin, piece.end);
    return envelope::expected_chords(envelope_, window, chord_);
}

void OutlineSampler::sample(std::size_t i, int threads)
{
    BoundaryPiece const& piece = pieces_[i];
    if (piece.arc < 0)
        return;
    envelope::SampledArc const found =
        envelope::sample_arc(envelope_, arc(piece), piece.begin, piece.end, chord_, threads);
    Sampled& kept = sampled_[i];
    kept.chord = found.chord;
    kept.error = found.error;
    kept.evaluations = found.evaluations;
    kept.points.reserve(found.points.size());
    for (envelope::EnvelopePoint const& e : found.points)
        kept.points.push_back(piece.copy == 0 ? e.p : turned_clockwise(e.p, piece.copy * pitch_));
}

Outline OutlineSampler::joined(double tip_radius, std::size_t from, std::size_t to) const
{
    Outline outline;
    std::size_t count = 1;
    for (std::size_t i = from; i < to; ++i)
        count += pieces_[i].arc < 0 ? land_chords(tip_radius, pieces_[i].begin, pieces_[i].end, chord_)
                                    : sampled_[i].points.size() - 1;
    outline.points.reserve(count);
    BoundaryPiece const* before = nullptr;  // the one that ends where this one begins, unless it is land
    for (std::size_t i = from; i < to; ++i) {
        BoundaryPiece const& piece = pieces_[i];
        if (piece.arc < 0) {
            append_land(outline, tip_radius, piece.begin, piece.end, chord_);
            before = nullptr;
            continue;
        }
        Sampled const& sampled = sampled_[i];
        outline.chord = std::max(outline.chord, sampled.chord);
        outline.error = std::max(outline.error, sampled.error);
        outline.evaluations += sampled.evaluations;
        std::size_t const first = outline.points.empty() ? 0 : outline.points.size() - 1;
        outline.points.insert(outline.points.end(), sampled.points.begin() + (outline.points.empty() ? 0 : 1),
                              sampled.points.end());
        if (before == nullptr || !outline_goes_on(envelope_.profile(), *before, arc(*before), piece, arc(piece))) {
            outline.stretches.push_back(made_by(envelope_.profile(), arc(piece)));
            outline.stretches.back().first = first;
        }
        outline.stretches.back().last = outline.points.size() - 1;
        before = &piece;
    }
    return outline;
}

Outline sample_outline(envelope::AnyEnvelope const& envelope, std::vector<envelope::ContactArc> const& arcs,
                       std::vector<BoundaryPiece> const& pieces, double tip_radius, double pitch, double chord,
                       int threads)
{
    OutlineSampler sampler(envelope, arcs, pieces, pitch, chord);
    for (std::size_t i = 0; i < sampler.count(); ++i)
        sampler.sample(i, threads);
    return sampler.joined(tip_radius, 0, sampler.count());
}

Halves cut_at_centre_line(envelope::AnyEnvelope const& envelope, std::vector<envelope::ContactArc> const& arcs,
                          std::vector<BoundaryPiece> const& pieces, double pitch, Tolerance const& tolerance)
{
    auto const x_at = [&](BoundaryPiece const& piece, double u) {
        return TurnedArc<motion::AnyMotion>{envelope, arcs[static_cast<std::size_t>(piece.arc)], piece.copy * pitch}
            .point(u)
            .p.x();
    };
    Halves halves;
    bool crossed = true;
    for (BoundaryPiece const& piece : pieces) {
        double const x_begin = piece.arc < 0 ? piece.begin : x_at(piece, piece.begin);
        double const x_end = piece.arc < 0 ? piece.end : x_at(piece, piece.end);
        if (!halves.right.empty()) {
            halves.right.push_back(piece);
        } else if (x_end <= tolerance.roundoff()) {
            halves.left.push_back(piece);
        } else if (x_begin < -tolerance.roundoff() && piece.arc >= 0) {
            auto const x = [&](double u) { return x_at(piece, u); };
            numeric::BracketedRoot const root =
                numeric::bracketed_root(x, std::min(piece.begin, piece.end), std::max(piece.begin, piece.end));
            crossed = crossed && root.found;
            halves.left.push_back({piece.arc, piece.copy, piece.begin, root.x});
            halves.right.push_back({piece.arc, piece.copy, root.x, piece.end});
        } else {
            halves.right.push_back(piece);
        }
    }
    if (!crossed || halves.left.empty() || halves.right.empty())
        throw NumericalError(ErrorCode::no_outline, "outline", "middle of the tooth space",
                             "does not cross the centre line");
    return halves;
}

Outline mirrored(Outline const& half, profile::Profile const& tooth)
{
    Outline image;
    image.chord = half.chord;
    image.error = half.error;
    std::size_t const last = half.points.size() - 1;
    image.points.reserve(2 * half.points.size() + 2);  // the other half follows, and root walls may
    for (auto p = half.points.rbegin(); p != half.points.rend(); ++p)
        image.points.emplace_back(-p->x(), p->y());
    image.stretches = mirrored(half.stretches, tooth, last);
    return image;
}

CentredOutlineSampler::CentredOutlineSampler(envelope::AnyEnvelope const& envelope,
                                             std::vector<envelope::ContactArc> const& arcs,
                                             std::vector<BoundaryPiece> const& pieces, double tip_radius, double pitch,
                                             Tolerance const& tolerance, double chord)
    : profile_(envelope.profile()), tip_radius_(tip_radius)
{
    Halves halves = cut_at_centre_line(envelope, arcs, pieces, pitch, tolerance);
    right_ = halves.right.size();
    if (!(profile_.mirror_symmetric && envelope.motion().symmetric()))
        halves.right.insert(halves.right.end(), halves.left.begin(), halves.left.end());
    pieces_.emplace(envelope, arcs, std::move(halves.right), pitch, chord);
}

CentredOutline CentredOutlineSampler::joined() const
{
    std::size_t const all = pieces_->count();
    Outline right = pieces_->joined(tip_radius_, 0, right_);
    right.points.front().x() = 0;
    CentredOutline result{right_ < all ? pieces_->joined(tip_radius_, right_, all) : mirrored(right, profile_), 0};
    Outline& whole = result.outline;
    result.middle = whole.points.size() - 1;
    whole.points.back() = right.points.front();
    append_outline(whole, right);
    return result;
}

}  // namespace hdconj::conjugate
