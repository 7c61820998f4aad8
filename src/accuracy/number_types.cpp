// SPDX-License-Identifier: GPL-3.0-or-later
// Closed form of an arc's contact in float, double and long double, and by the program.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <variant>
#include <vector>

#include "accuracy/reference/reference_contact.hpp"
#include "hdconj/error.hpp"
#include "study_bench.hpp"

namespace hdconj::accuracy {
namespace {

using Wide = long double;

/// The same contacts of one arc, in the type T.
template <class T>
void in_type(StudyBench const& bench, ReferenceCurve const& truth, profile::ArcPiece const& arc, int side,
             std::size_t tooth, std::vector<double> const& u, char const* method)
{
    ReferenceView<T> const motion = bench.drive.view<T>(tooth);
    T const lifted = static_cast<T>(bench.drive.reverse() ? bench.drive.geometry.pitch_line : 0);
    StudyRecord record{"number-type", {}, method, "bits of the significand", double{std::numeric_limits<T>::digits}};
    double worst = 0, rest = 0;
    for (double const at : u) {
        ReferenceContact<T> const contact = contact_at(arc, side, motion.at(T(at)), T(bench.drive.offset));
        worst = std::max(
            worst, truth.distance(static_cast<Wide>(contact.point.x), static_cast<Wide>(contact.point.y - lifted)));
        rest = std::max(rest, static_cast<double>(std::abs(inner(contact.normal, contact.velocity))));
    }
    record.error = record.hausdorff = worst;
    record.normal_speed = rest;
    record.evaluations = record.points = static_cast<double>(u.size());
    T sum(0);
    bench.measure(record, [&] {
        for (double const at : u)
            sum += contact_at(arc, side, motion.at(T(at)), T(bench.drive.offset)).point.x;
    });
    if (!(sum == sum))
        throw NumericalError(ErrorCode::not_converged, "study number-type", method, "a contact is no number");
}

/// Those of the program itself.
void by_program(StudyBench const& bench, ReferenceCurve const& truth, conjugate::BoundaryPiece const& piece,
                std::vector<double> const& u)
{
    envelope::AnyEnvelope const envelope = bench.drive.envelope(piece);
    envelope::ContactArc const& arc = bench.drive.arc(piece);
    StudyRecord record{
        "number-type", {}, "the program", "bits of the significand", double{std::numeric_limits<double>::digits}};
    double worst = 0;
    for (double const at : u) {
        envelope::EnvelopePoint const point = envelope.point(arc, at);
        worst = std::max(worst, truth.distance(bench.drive.placed(piece, point.p)));
        record.estimate = std::fmax(record.estimate, point.error);
    }
    record.error = record.hausdorff = worst;
    record.evaluations = record.points = static_cast<double>(u.size());
    double sum = 0;
    bench.measure(record, [&] {
        for (double const at : u)
            sum += envelope.point(arc, at).p.x();
    });
    if (!(sum == sum))
        throw NumericalError(ErrorCode::not_converged, "study number-type", "the program", "a contact is no number");
}

}  // namespace

void study_precision(StudyBench const& bench)
{
    StudyDrive const& drive = bench.drive;
    conjugate::BoundaryPiece const* chosen = longest_flank(
        bench, [&](auto const& piece) { return std::holds_alternative<profile::ArcPiece>(drive.shape_of(piece)); });
    if (chosen == nullptr)
        return bench.note("number-type",
                          "no arc of the flank bounds the tooth space; the study is of the closed form on arcs");
    conjugate::BoundaryPiece in_place = *chosen;
    if (!drive.reverse())
        in_place.copy = 0;
    std::size_t const tooth = drive.tooth_of(in_place);
    ReferenceCurve const truth = reference_of(drive, in_place);
    envelope::ContactArc const& arc = drive.arc(in_place);
    auto const& circle = std::get<profile::ArcPiece>(drive.shape_of(in_place));
    constexpr int points = 512, points_of_quick = 64;
    int const count = bench.quick ? points_of_quick : points;
    std::vector<double> u;
    // inside the stretch by a little, so that roundoff in float does not leave it; the same positions, exact in float,
    // for all types
    for (int i = 0; i < count; ++i)
        u.push_back(static_cast<double>(
            static_cast<float>(in_place.begin + (in_place.end - in_place.begin) * (i + 0.5) / count)));
    in_type<float>(bench, truth, circle, arc.candidate, tooth, u, "float");
    in_type<double>(bench, truth, circle, arc.candidate, tooth, u, "double");
    in_type<long double>(bench, truth, circle, arc.candidate, tooth, u, "long double");

    by_program(bench, truth, in_place, u);
}

}  // namespace hdconj::accuracy
