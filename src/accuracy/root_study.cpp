// SPDX-License-Identifier: GPL-3.0-or-later
// How contacts are found: closed form on arcs and lines, certified roots on curves, and a plain scan.
#include <algorithm>
#include <cmath>
#include <variant>

#include "accuracy/reference/reference_contact.hpp"
#include "hdconj/envelope/contact.hpp"
#include "hdconj/error.hpp"
#include "hdconj/numeric/bracketed_root.hpp"
#include "profile/measured_points.hpp"
#include "study_bench.hpp"

namespace hdconj::accuracy {
namespace {

using Wide = long double;

/// Cubic pieces through points of the right flank's arcs and lines; its own curves where it has some.
std::vector<profile::CurvePiece> general_flank(profile::Profile const& tooth)
{
    std::vector<profile::CurvePiece> pieces;
    std::vector<Vec2> points;
    for (profile::ProfilePiece const& piece : tooth.pieces) {
        if (piece.corner || !(profile::point_at(piece.shape, 0.5).x() > 0) ||
            std::abs(profile::start_of(piece.shape).normal.y()) > 1 - 0x1p-20)
            continue;
        if (auto const* curve = std::get_if<profile::CurvePiece>(&piece.shape)) {
            pieces.push_back(*curve);
            continue;
        }
        constexpr int steps = 10;
        for (int i = points.empty() ? 0 : 1; i <= steps; ++i)
            points.push_back(profile::point_at(piece.shape, static_cast<double>(i) / steps));
    }
    if (points.size() > 3)
        for (profile::CurvePiece& piece : profile::spline_through(points))
            pieces.push_back(std::move(piece));
    return pieces;
}

struct Instants
{
    std::vector<double> u;
    std::vector<motion::MotionRates> rates;
    std::vector<MovingFrame<Wide>> places;
};

/// Equal steps over the lobe, and ever closer to the places where two contacts of @p pieces merge, on either side:
/// there a scan is tried.
Instants instants_of(StudyDrive const& drive, std::vector<profile::CurvePiece> const& pieces, int count)
{
    ReferenceView<Wide> const wide = drive.view<Wide>();
    Instants all;
    double const half = drive.motion().half_lobe();
    for (int k = 0; k < count; ++k)
        all.u.push_back(-half + (2 * k + 1) * half / count);
    for (double const fold : fold_angles(drive.motion(), pieces)) {
        constexpr int nearest = 18;
        for (int power = 4; power <= nearest; power += 2)
            for (int const side : {-1, 1})
                all.u.push_back(fold + side * std::ldexp(1.0, -power));
    }
    for (double const u : all.u) {
        all.rates.push_back(drive.motion().rates(u));
        all.places.push_back(wide.at(u));
    }
    return all;
}

/// A root on a piece at an instant.
struct Found
{
    std::size_t instant, piece;
    double t;
};

/// All of them by signs at @p steps + 1 places of each piece, and bracketing.
std::vector<Found> scanned(std::vector<profile::CurvePiece> const& pieces, Instants const& at, int steps,
                           std::size_t& evaluations)
{
    std::vector<Found> found;
    for (std::size_t k = 0; k < at.u.size(); ++k) {
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            numeric::BernsteinWork f{};
            std::span<double> const coefficients(f.data(), pieces[i].a().size());
            (void)envelope::meshing_polynomial(pieces[i], at.rates[k].twist, coefficients);
            auto const value = [&](double t) {
                ++evaluations;
                return numeric::bernstein_value(coefficients, t);
            };
            double before = value(0);
            for (int step = 1; step <= steps; ++step) {
                double const now = value(static_cast<double>(step) / steps);
                if ((before < 0) != (now < 0)) {
                    numeric::BracketedRoot const root = numeric::bracketed_root(
                        value, (step - 1.0) / steps, static_cast<double>(step) / steps, before, now);
                    found.push_back({k, i, root.x});
                }
                before = now;
            }
        }
    }
    return found;
}

std::vector<Found> certified(std::vector<profile::CurvePiece> const& pieces, Instants const& at)
{
    std::vector<Found> found;
    for (std::size_t k = 0; k < at.u.size(); ++k)
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            numeric::BernsteinRoots const roots = envelope::curve_contacts(pieces[i], at.rates[k].twist);
            for (int r = 0; r < roots.count; ++r)
                found.push_back({k, i, roots.t[static_cast<std::size_t>(r)]});
        }
    return found;
}

/// Distance of the contact that a root stands for from the true one along the profile, in long double; `residual` gets
/// |n.v|.
double worst_root(std::vector<profile::CurvePiece> const& pieces, Instants const& at, std::vector<Found> const& found,
                  double& residual)
{
    Wide worst = 0, rest = 0;
    for (Found const& root : found) {
        profile::CurvePiece const& piece = pieces[root.piece];
        MovingFrame<Wide> const& place = at.places[root.instant];
        ReferenceContact<Wide> const truth = contact_at(piece, root.t, place, Wide(0));
        Pair<Wide> const x{casteljau(piece.x(), Wide(root.t)), casteljau(piece.y(), Wide(root.t))};
        Pair<Wide> const slope{casteljau(numeric::bernstein_derivative(piece.x()), Wide(root.t)),
                               casteljau(numeric::bernstein_derivative(piece.y()), Wide(root.t))};
        Pair<Wide> const n = (Wide(1) / length(slope)) * to_left(slope);
        rest = std::max(rest, std::abs(inner(place.turned(n), place.velocity(x))));
        worst = std::max(worst, length(place.point(x) - truth.point));
    }
    residual = static_cast<double>(rest);
    return static_cast<double>(worst);
}

/// Roots that one list has more of than another, instant by instant and piece by piece.
int surplus(std::vector<Found> const& of, std::vector<Found> const& over, std::size_t instants, std::size_t pieces)
{
    std::vector<int> count(instants * pieces, 0);
    for (Found const& root : of)
        ++count[root.instant * pieces + root.piece];
    for (Found const& root : over)
        --count[root.instant * pieces + root.piece];
    int sum = 0;
    for (int const difference : count)
        sum += std::max(0, difference);
    return sum;
}

StudyRecord roots_record(char const* method, double value)
{
    return {"roots", {}, method, "scan steps of a piece", value};
}

/// Every arc contact of the tooth at every instant, in closed form.
void closed_form(StudyBench const& bench, Instants const& at)
{
    std::vector<profile::ArcPiece> arcs;
    for (profile::ProfilePiece const& piece : bench.drive.tooth.pieces)
        if (auto const* arc = std::get_if<profile::ArcPiece>(&piece.shape);
            arc != nullptr && !piece.corner && profile::point_at(piece.shape, 0.5).x() > 0)
            arcs.push_back(*arc);
    if (arcs.empty())
        return;
    std::size_t count = 0;
    auto const run = [&](auto const& use) {
        count = 0;
        for (std::size_t k = 0; k < at.u.size(); ++k)
            for (profile::ArcPiece const& arc : arcs)
                for (int const side : {1, -1}) {
                    envelope::Contact const contact = envelope::arc_contact(arc, at.rates[k], side, 0);
                    ++count;
                    use(k, arc, side, contact);
                }
    };
    Wide worst = 0, rest = 0;
    int roots = 0;
    run([&](std::size_t k, profile::ArcPiece const& arc, int side, envelope::Contact const& contact) {
        if (!(contact.t >= 0 && contact.t <= 1))
            return;
        ++roots;
        ReferenceContact<Wide> const truth = contact_at(arc, side, at.places[k], Wide(0));
        Pair<Wide> const x = pair_of<Wide>(contact.x), n = pair_of<Wide>(contact.n);
        rest = std::max(rest, std::abs(inner(at.places[k].turned(n), at.places[k].velocity(x))));
        worst = std::max(worst, length(at.places[k].point(x) - truth.point));
    });
    StudyRecord record = roots_record("closed form (arcs)", 1);
    record.error = record.hausdorff = static_cast<double>(worst);
    record.normal_speed = static_cast<double>(rest);
    record.branches = roots;
    record.evaluations = static_cast<double>(count);
    record.points = roots;
    double sum = 0;
    bench.measure(record, [&] {
        run([&](std::size_t, profile::ArcPiece const&, int, envelope::Contact const& contact) { sum += contact.t; });
    });
    if (!(sum == sum))
        throw NumericalError(ErrorCode::not_converged, "study roots", "closed form", "a contact is no number");
}

}  // namespace

void study_roots(StudyBench const& bench)
{
    constexpr int instants = 256, instants_of_quick = 48;
    std::vector<profile::CurvePiece> const pieces = general_flank(bench.drive.tooth);
    Instants const at = instants_of(bench.drive, pieces, bench.quick ? instants_of_quick : instants);
    closed_form(bench, at);
    if (pieces.empty())
        return bench.note("roots", "the flank has too few points for a spline");
    std::vector<Found> const proved = certified(pieces, at);
    StudyRecord record = roots_record("certified (spline)", 1);
    record.error = record.hausdorff = worst_root(pieces, at, proved, record.normal_speed);
    record.branches = static_cast<int>(proved.size());
    record.evaluations = static_cast<double>(pieces.size() * at.u.size());
    record.points = static_cast<double>(proved.size());
    bench.measure(record, [&] { (void)certified(pieces, at); });
    constexpr int most = 64, most_of_sample = 16, most_of_quick = 8;
    for (int steps = 1; steps <= bench.length(most, most_of_sample, most_of_quick); steps *= 2) {
        std::size_t evaluations = 0;
        std::vector<Found> const found = scanned(pieces, at, steps, evaluations);
        record = roots_record("scan and bracket (spline)", steps);
        record.error = record.hausdorff = worst_root(pieces, at, found, record.normal_speed);
        record.branches = static_cast<int>(found.size());
        record.missed = surplus(proved, found, at.u.size(), pieces.size());
        record.extra = surplus(found, proved, at.u.size(), pieces.size());
        record.evaluations = static_cast<double>(evaluations);
        record.points = static_cast<double>(found.size());
        bench.measure(record, [&] { (void)scanned(pieces, at, steps, evaluations); });
    }
}

}  // namespace hdconj::accuracy
