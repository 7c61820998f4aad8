// SPDX-License-Identifier: GPL-3.0-or-later
#include "outline_sampler.hpp"

#include <algorithm>

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

}  // namespace hdconj::conjugate
