// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference_drive.hpp"

#include <string>
#include <type_traits>
#include <variant>

#include "hdconj/base/stop.hpp"
#include "hdconj/error.hpp"

namespace hdconj::accuracy {
namespace {

/// n.v along a polynomial, n as long as the slope, with two derivatives by t.
struct AlongCurve
{
    Fifty f, f1, f2;
};

AlongCurve along_curve(profile::CurvePiece const& curve, MovingFrame<Fifty> const& place, Fifty const& t)
{
    std::array<Pair<Fifty>, 4> x;  // and its derivatives
    std::vector<double> cx(curve.x().begin(), curve.x().end()), cy(curve.y().begin(), curve.y().end());
    for (Pair<Fifty>& each : x) {
        each = cx.empty() ? Pair<Fifty>{} : Pair<Fifty>{casteljau(cx, t), casteljau(cy, t)};
        cx = cx.size() > 1 ? numeric::bernstein_derivative(cx) : std::vector<double>{};
        cy = cy.size() > 1 ? numeric::bernstein_derivative(cy) : std::vector<double>{};
    }
    auto const normal = [&](std::size_t i) { return place.turned(to_left(x[i])); };
    auto const speed = [&](std::size_t i) { return x[i].x * place.along_rate + x[i].y * place.outward_rate; };
    Pair<Fifty> const v = place.velocity(x[0]);
    return {inner(normal(1), v), inner(normal(2), v) + inner(normal(1), speed(1)),
            inner(normal(3), v) + Fifty(2) * inner(normal(2), speed(1)) + inner(normal(1), speed(2))};
}

}  // namespace

ReferenceDrive::ReferenceDrive(StudyDrive const& drive) : drive_(drive), views_(drive.views<Fifty>())
{
    if (drive.scene.solver.kinematics != Kinematics::material)
        breaks_ = views_.front().motion().curve().breaks();
}

ReferenceContact<Fifty> ReferenceDrive::on_tooth(conjugate::BoundaryPiece const& piece, MovingFrame<Fifty> const& place,
                                                 Fifty const& u) const
{
    envelope::ContactArc const& arc = drive_.arc(piece);
    if (arc.resting)
        throw NumericalError(ErrorCode::no_reference, "reference", "profile piece " + std::to_string(arc.piece),
                             "an arc's centre is at rest, which has no reference in 50 digits");
    Fifty const offset(drive_.offset);
    return std::visit(
        [&](auto const& shape) {
            if constexpr (std::is_same_v<std::decay_t<decltype(shape)>, profile::CurvePiece>)
                return contact_at(shape, drive_.envelope(piece).contact(arc, static_cast<double>(u)).t, place, offset);
            else
                return contact_at(shape, arc.candidate, place, offset);
        },
        drive_.shape_of(piece));
}

ReferenceContact<Fifty> ReferenceDrive::contact(conjugate::BoundaryPiece const& piece, Fifty const& u) const
{
    end_if_stopped();
    ReferenceContact<Fifty> found = on_tooth(piece, views_[drive_.tooth_of(piece)].at(u), u);
    if (drive_.reverse()) {
        found.point.y -= Fifty(drive_.geometry.pitch_line);
    } else if (piece.copy != 0) {
        Fifty const angle = Fifty(piece.copy) * Fifty(2) * half_pitch();
        Fifty const c = cos(angle), s = sin(angle);
        found.point = turned(found.point, c, s);
        found.normal = turned(found.normal, c, s);
    }
    return found;
}

Fifty ReferenceDrive::lean(conjugate::BoundaryPiece const& piece, Fifty const& u) const
{
    MovingFrame<Fifty> const place = views_[drive_.tooth_of(piece)].at(u);
    return inner(on_tooth(piece, place, u).normal, place.along);
}

Fifty ReferenceDrive::merged(conjugate::BoundaryPiece const& piece, double u) const
{
    envelope::ContactArc const& arc = drive_.arc(piece);
    bool const begins = u == arc.u_begin && arc.begins == envelope::BranchEnd::double_root,
               ends = u == arc.u_end && arc.ends == envelope::BranchEnd::double_root;
    auto const* curve = std::get_if<profile::CurvePiece>(&drive_.shape_of(piece));
    if (curve == nullptr || !(begins || ends))
        return Fifty(u);
    ReferenceView<Fifty> const& view = views_[drive_.tooth_of(piece)];
    // Newton's method on f = f_t = 0; derivatives by u as difference quotients
    Fifty t(begins ? arc.t_begin : arc.t_end), at(u);
    Fifty const h("1e-22"), enough("1e-32");
    constexpr int budget = 30;
    for (int i = 0; i < budget; ++i) {
        AlongCurve const here = along_curve(*curve, view.at(at), t), later = along_curve(*curve, view.at(at + h), t);
        Fifty const f_u = (later.f - here.f) / h, f1_u = (later.f1 - here.f1) / h;
        Fifty const determinant = here.f1 * f1_u - f_u * here.f2;
        Fifty const dt = (here.f * f1_u - f_u * here.f1) / determinant,
                    du = (here.f1 * here.f1 - here.f * here.f2) / determinant;
        t -= dt;
        at -= du;
        if (abs(dt) < enough && abs(du) < enough)
            return at;
    }
    throw NumericalError(ErrorCode::not_converged, "reference",
                         "profile piece " + std::to_string(arc.piece) + " at u = " + std::to_string(u),
                         "where two contacts merge did not converge in 50 digits");
}

}  // namespace hdconj::accuracy
