// SPDX-License-Identifier: GPL-3.0-or-later
#include "records.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>

#include "zone_error.hpp"

namespace hdconj::conjugate {
namespace {

/// Whether any boundary piece runs on the contact followed by @p arc. Boundary arcs may come from a trace at another
/// offset, whose cusps differ; contacts are the same, so piece, candidate and instant decide.
bool bounds_somewhere(envelope::ContactArc const& arc, double from, double to,
                      std::vector<envelope::ContactArc> const& boundary_arcs, std::vector<BoundaryPiece> const& pieces)
{
    return std::any_of(pieces.begin(), pieces.end(), [&](BoundaryPiece const& piece) {
        if (piece.arc < 0)
            return false;
        envelope::ContactArc const& other = boundary_arcs[static_cast<std::size_t>(piece.arc)];
        double const low = std::max(from, std::min(piece.begin, piece.end));
        double const high = std::min(to, std::max(piece.begin, piece.end));
        return other.piece == arc.piece && other.candidate == arc.candidate && high > low;
    });
}

/// Name of a branch's origin: the segment's, or "corner A / B".
std::string origin_name(profile::Profile const& profile, envelope::Branch const& branch)
{
    auto const name = [&](int segment) { return profile.segment_names[static_cast<std::size_t>(segment)]; };
    if (!branch.corner)
        return name(branch.segment);
    auto const after = static_cast<std::size_t>(branch.arcs.front().piece) + 1;
    return "corner " + name(branch.segment) + " / " + name(profile.pieces[after].segment);
}

}  // namespace

BranchRecord branch_record(envelope::AnyEnvelope const& envelope, envelope::Branch const& branch, double chord,
                           std::size_t& evaluations)
{
    BranchRecord record;
    record.kind = branch.corner ? "corner" : "regular";
    record.segment = branch.segment;
    record.segment_name = origin_name(envelope.profile(), branch);
    record.begins = envelope::to_string(branch.arcs.front().begins);
    record.ends = envelope::to_string(branch.arcs.back().ends);
    std::optional<motion::CosineForm> const batch = motion::cosine_form(envelope.motion());
    for (envelope::ContactArc const& arc : branch.arcs) {
        profile::ProfilePiece const& piece = envelope.profile().pieces[static_cast<std::size_t>(arc.piece)];
        // neighbouring arcs share their common point
        std::size_t skipped = record.u.empty() ? 0 : 1;
        auto const keep = [&](std::span<envelope::EnvelopePoint const> points, std::size_t to_come) {
            std::size_t const first = record.u.size();
            std::size_t const count = points.size() - skipped;
            for (auto* column : {&record.u, &record.phi, &record.t}) {
                envelope::make_room(*column, to_come);
                column->resize(first + count);
            }
            envelope::make_room(record.point, to_come);
            for (std::size_t k = 0; k < count; ++k) {
                envelope::EnvelopePoint const& e = points[skipped + k];
                record.u[first + k] = e.u;
                record.t[first + k] =
                    std::clamp(piece.t_begin + e.t * (piece.t_end - piece.t_begin), piece.t_begin, piece.t_end);
                record.point.push_back(e.p);
            }
            skipped = 0;
            if (batch) {
                // the parameter of this motion is u
                envelope::undeformed_angles(*batch, std::span(record.u).subspan(first),
                                            std::span(record.phi).subspan(first));
                return;
            }
            for (std::size_t k = first; k < first + count; ++k) {
                motion::ToothAngles const angles = envelope.motion().angles(record.u[k]);
                record.u[k] = angles.u;
                record.phi[k] = angles.phi;
            }
        };
        evaluations += envelope::sample_arc_in_parts(envelope, arc, chord, keep).evaluations;
    }
    return record;
}

void append_zones(envelope::AnyEnvelope const& envelope, envelope::Branch const& branch, std::size_t index,
                  std::vector<envelope::ContactArc> const& boundary_arcs, std::vector<BoundaryPiece> const& pieces,
                  std::vector<ConjugateZone>& zones)
{
    auto const segment_t = [&](envelope::ContactArc const& arc, double u) {
        profile::ProfilePiece const& piece = envelope.profile().pieces[static_cast<std::size_t>(arc.piece)];
        double const t = u == arc.u_begin ? arc.t_begin : u == arc.u_end ? arc.t_end : envelope.contact(arc, u).t;
        return piece.t_begin + t * (piece.t_end - piece.t_begin);
    };
    struct EndError
    {
        double phi = 0, t = 0;
    };
    auto const end_error = [&](envelope::ContactArc const& arc, double u, ZoneEnd end) {
        double const doubt = zone_angle_error(envelope, arc, u, end);
        double const h = 0.5 * (arc.u_end - arc.u_begin);
        double const rate =
            std::abs(envelope.motion().angles(u + h).phi - envelope.motion().angles(u - h).phi) / (2 * h);
        profile::ProfilePiece const& piece = envelope.profile().pieces[static_cast<std::size_t>(arc.piece)];
        return EndError{std::max(1.0, rate) * doubt,
                        zone_t_error(envelope, arc, u, doubt) * std::abs(piece.t_end - piece.t_begin)};
    };
    EndError begins;
    bool open = false;
    for (envelope::ContactArc const& arc : branch.arcs) {
        std::vector<double> cuts{arc.u_begin};
        cuts.insert(cuts.end(), arc.reversals.begin(), arc.reversals.end());
        cuts.push_back(arc.u_end);
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
            // a zone goes on across the joint of two pieces of one segment
            bool const same_zone = open && i == 0 && zones.back().outer == arc.bounding;
            if (!same_zone) {
                ConjugateZone zone;
                zone.segment = branch.segment;
                zone.segment_name = origin_name(envelope.profile(), branch);
                zone.kind = branch.corner ? "corner" : "regular";
                zone.branch = index;
                zone.outer = arc.bounding;
                motion::ToothAngles const angles = envelope.motion().angles(cuts[i]);
                zone.u_begin = angles.u;
                zone.phi_begin = angles.phi;
                zone.t_begin = segment_t(arc, cuts[i]);
                zones.push_back(zone);
                begins = end_error(arc, cuts[i], i == 0 ? zone_end(arc.begins) : ZoneEnd::reversal);
            }
            ConjugateZone& zone = zones.back();
            motion::ToothAngles const angles = envelope.motion().angles(cuts[i + 1]);
            zone.u_end = angles.u;
            zone.phi_end = angles.phi;
            zone.t_end = segment_t(arc, cuts[i + 1]);
            EndError const ends =
                end_error(arc, cuts[i + 1], i + 2 == cuts.size() ? zone_end(arc.ends) : ZoneEnd::reversal);
            zone.phi_error = std::max(begins.phi, ends.phi);
            zone.t_error = std::max(begins.t, ends.t);
            zone.on_boundary = zone.on_boundary || bounds_somewhere(arc, cuts[i], cuts[i + 1], boundary_arcs, pieces);
            open = true;
        }
    }
}

}  // namespace hdconj::conjugate
