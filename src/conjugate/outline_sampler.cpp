// SPDX-License-Identifier: GPL-3.0-or-later
#include "outline_sampler.hpp"

#include <algorithm>

#include "contact_at_end.hpp"

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

Outline OutlineSampler::joined(double tip_radius) const
{
    Outline outline;
    std::size_t count = 1;
    for (std::size_t i = 0; i < pieces_.size(); ++i)
        count += pieces_[i].arc < 0 ? land_chords(tip_radius, pieces_[i].begin, pieces_[i].end, chord_)
                                    : sampled_[i].points.size() - 1;
    outline.points.reserve(count);
    BoundaryPiece const* before = nullptr;  // the one that ends where this one begins, unless it is land
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
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
        OutlineKind const kind = kind_of(piece);
        int const segment = made_by(piece).segment;
        bool const goes_on = before != nullptr &&
                             contact_goes_on({arc(*before).piece, before->copy, before->end},
                                             {arc(piece).piece, piece.copy, piece.begin}, made_by(piece).corner) &&
                             outline.stretches.back().kind == kind && outline.stretches.back().segment == segment;
        if (goes_on)
            outline.stretches.back().last = outline.points.size() - 1;
        else
            outline.stretches.push_back({kind, segment, first, outline.points.size() - 1});
        before = &piece;
    }
    return outline;
}

envelope::ContactArc const& OutlineSampler::arc(BoundaryPiece const& piece) const
{
    return arcs_[static_cast<std::size_t>(piece.arc)];
}

profile::ProfilePiece const& OutlineSampler::made_by(BoundaryPiece const& piece) const
{
    return envelope_.profile().pieces[static_cast<std::size_t>(arc(piece).piece)];
}

OutlineKind OutlineSampler::kind_of(BoundaryPiece const& piece) const
{
    if (made_by(piece).corner)
        return OutlineKind::corner;
    return profile::is_tip(envelope_.profile(), arc(piece).piece) ? OutlineKind::bottom : OutlineKind::flank;
}

Outline sample_outline(envelope::AnyEnvelope const& envelope, std::vector<envelope::ContactArc> const& arcs,
                       std::vector<BoundaryPiece> const& pieces, double tip_radius, double pitch, double chord,
                       int threads)
{
    OutlineSampler sampler(envelope, arcs, pieces, pitch, chord);
    for (std::size_t i = 0; i < sampler.count(); ++i)
        sampler.sample(i, threads);
    return sampler.joined(tip_radius);
}

}  // namespace hdconj::conjugate
