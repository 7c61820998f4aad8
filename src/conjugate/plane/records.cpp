// SPDX-License-Identifier: GPL-3.0-or-later
#include "records.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>

#include "hdconj/base/tolerance.hpp"

namespace hdconj::conjugate {
namespace {

/// What makes a zone end where it does.
enum class ZoneEnd
{
    contact,   ///< f = 0 at the end of the segment, or f = df/dt = 0 where contacts merge; either way u solves f = 0
               ///< with the point held
    cusp,      ///< Contact::bound = 0
    reversal,  ///< Contact::turning = 0
    exact      ///< the lobe's end
};

ZoneEnd zone_end(envelope::BranchEnd end)
{
    return end == envelope::BranchEnd::cusp        ? ZoneEnd::cusp
           : end == envelope::BranchEnd::range_end ? ZoneEnd::exact
                                                   : ZoneEnd::contact;
}

/// Error of the angle @p u at which a zone on @p arc ends: the rounding of the function that vanishes there over its
/// slope, and no more than the arc is long. For f at a point held on the profile the slope is df/du = Contact::turning;
/// the others' is taken by differences within the arc. Accuracy: first order in the rounding, sizes of terms as in
/// Contact; roundings are counted generously.
/// @returns [parameter of the motion]
double zone_angle_error(envelope::AnyEnvelope const& envelope, envelope::ContactArc const& arc, double u, ZoneEnd end)
{
    constexpr double roundings = 16;
    double const length = arc.u_end - arc.u_begin;
    double const least = 2 * unit_roundoff * std::abs(u);
    double noise = 0, slope = 1;
    if (end == ZoneEnd::contact) {
        motion::MotionRates const rates = envelope.motion().rates(u);
        bool const at_begin = std::abs(u - arc.u_begin) < std::abs(u - arc.u_end);
        double const t = at_begin ? arc.t_begin : arc.t_end;
        profile::PieceShape const& shape = envelope.shape(arc);
        Vec2 x, n;
        if (t == 0 || t == 1) {
            profile::PieceEnd const held = t == 0 ? profile::start_of(shape) : profile::end_of(shape);
            x = held.point;
            n = held.normal;
        } else {
            envelope::Contact const c = envelope.contact(arc, u);
            x = c.x - envelope.offset() * c.n;
            n = c.n;
        }
        noise = rates.velocity_size(x);
        slope = std::abs(n.dot(rates.change(x)));
    } else if (end == ZoneEnd::cusp || end == ZoneEnd::reversal) {
        auto const value = end == ZoneEnd::cusp ? &envelope::Contact::bound : &envelope::Contact::turning;
        auto const size = end == ZoneEnd::cusp ? &envelope::Contact::bound_size : &envelope::Contact::turning_size;
        double const h = length * 0x1p-12;
        double const low = std::max(arc.u_begin, u - h), high = std::min(arc.u_end, u + h);
        noise = envelope.contact(arc, u).*size;
        slope = std::abs(envelope.contact(arc, high).*value - envelope.contact(arc, low).*value) / (high - low);
    }
    double const error = roundings * unit_roundoff * noise / slope;
    return error < length ? error + least : length;
}

/// Error of the segment's parameter t of the contact on @p arc at @p u, which is uncertain by @p angle: rounding at a
/// given u, and how far t runs meanwhile. None where the zone ends with the segment.
double zone_t_error(envelope::AnyEnvelope const& envelope, envelope::ContactArc const& arc, double u, double angle)
{
    double const known = u == arc.u_begin ? arc.t_begin : u == arc.u_end ? arc.t_end : -1;
    if (known == 0 || known == 1 || arc.resting)
        return 0;
    profile::PieceShape const& shape = envelope.shape(arc);
    double const inward = u - arc.u_begin < arc.u_end - u ? 1 : -1;
    double const h = (arc.u_end - arc.u_begin) * 0x1p-12;
    envelope::Contact const here = envelope.contact(arc, u), there = envelope.contact(arc, u + inward * h);
    constexpr double roundings = 8;
    double along = 0;
    if (auto const* circle = std::get_if<profile::ArcPiece>(&shape)) {
        // corners too, whose cone of normals t counts
        motion::MotionRates const rates = envelope.motion().rates(u);
        along = rates.velocity_size(circle->centre) /
                (rates.twist(circle->centre).norm() * std::abs(circle->to - circle->from));
    } else {
        along = std::min(here.rounding, there.rounding) /
                (profile::start_of(shape).point - profile::end_of(shape).point).norm();
    }
    double const error = roundings * unit_roundoff * along + std::abs(there.t - here.t) / h * angle + unit_roundoff;
    return error < 1 ? error : 1;
}

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

ToothOutline::ToothOutline(profile::Profile const& profile, double chord, std::vector<Vec2>& points)
    : pitch_line_(profile.pitch_line), points_(points)
{
    std::size_t count = 1;
    for (profile::ProfilePiece const& piece : profile.pieces) {
        if (piece.corner)
            continue;
        runs_.push_back({&piece.shape, count, profile::steps_of(piece.shape, chord)});
        count += static_cast<std::size_t>(runs_.back().steps);
    }
    points_.resize(count);
}

void ToothOutline::operator()(std::size_t b) const
{
    std::size_t const last = std::min(points_.size(), (b + 1) * block);
    std::size_t k = b * block;
    if (k == 0) {
        points_.front() = profile::start_of(*runs_.front().shape).point;
        points_.front().y() -= pitch_line_;
        k = 1;
    }
    auto run = std::upper_bound(runs_.begin(), runs_.end(), k,
                                [](std::size_t point, Run const& r) { return point < r.before; }) -
               1;
    for (; k < last; ++k) {
        while (k >= run->before + static_cast<std::size_t>(run->steps))
            ++run;
        points_[k] = profile::point_at(*run->shape, static_cast<double>(k - run->before + 1) / run->steps);
        points_[k].y() -= pitch_line_;
    }
}

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
                  Solution& out)
{
    std::vector<ConjugateZone>& zones = out.zones;
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
            out.branches[index].on_boundary = out.branches[index].on_boundary || zone.on_boundary;
            open = true;
        }
    }
}

void add_positions(profile::Profile const& tooth, motion::AnyMotion const& motion, double down,
                   std::vector<std::vector<Vec2>>& family)
{
    constexpr int positions = 40;
    std::vector<Vec2> const polygon = profile::polygon_of(tooth, (tooth.addendum + tooth.dedendum) * 0x1p-10);
    for (int i = 0; i <= positions; ++i) {
        Pose const pose = motion.pose(motion.half_lobe() * (2.0 * i / positions - 1));
        std::vector<Vec2> placed;
        placed.reserve(polygon.size());
        for (Vec2 const& p : polygon)
            placed.push_back(pose(p) - Vec2(0, down));
        family.push_back(std::move(placed));
    }
}

}  // namespace hdconj::conjugate
