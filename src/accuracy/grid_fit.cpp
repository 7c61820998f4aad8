// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid_fit.hpp"

#include <cmath>
#include <variant>

#include "hdconj/accuracy.hpp"
#include "numeric/least_squares.hpp"

namespace hdconj::accuracy {

OnPiece on_piece(profile::PieceShape const& shape, double t)
{
    if (auto const* arc = std::get_if<profile::ArcPiece>(&shape)) {
        Vec2 const n = direction(arc->from + t * (arc->to - arc->from));
        return {arc->centre + arc->radius * n, n};
    }
    if (auto const* line = std::get_if<profile::LinePiece>(&shape))
        return {line->a + t * (line->b - line->a), line->normal()};
    auto const& curve = std::get<profile::CurvePiece>(shape);
    return {curve.point(t), left_of(curve.first(t)).normalized()};
}

GridPoints GridAndFit::points(StudyDrive const& drive, motion::AnyMotion const& motion,
                              conjugate::BoundaryPiece const& piece, double from, double to,
                              std::vector<double> const& contacts)
{
    auto const count = static_cast<int>(contacts.size());
    envelope::ContactArc const& arc = drive.arc(piece);
    profile::PieceShape const& shape = drive.shape_of(piece);
    double t = piece.begin == arc.u_begin ? arc.t_begin
               : piece.begin == arc.u_end ? arc.t_end
                                          : drive.envelope(piece).point(arc, piece.begin).t;
    GridPoints result;
    for (int i = 0; i < count; ++i) {
        double const s = from + (to - from) * i / (count - 1);
        double const found = secant_root(shape, motion.rates(s).twist, t),
                     right = contacts[static_cast<std::size_t>(i)];
        // The method sees by itself that it has left the flank; the next step begins with the last kept value.
        bool const kept = found >= -rounding_of_t && found <= 1 + rounding_of_t;
        if (kept)
            t = found;
        if (!kept || !(std::abs(found - right) <= same_contact)) {
            ++result.missed;
            result.extra += kept;
            continue;
        }
        OnPiece const on = on_piece(shape, t);
        result.points.push_back(drive.placed(piece, motion.pose(s)(on.x + drive.offset * on.n)));
        result.steps.push_back(i);
    }
    return result;
}

std::vector<Vec2> GridAndFit::fitted(std::vector<Vec2> const& points, int degree)
{
    Vec2 const a = points.front(), b = points.back();
    bool const steep = std::abs(b.y() - a.y()) > std::abs(b.x() - a.x());
    auto const free = [&](Vec2 const& p) { return steep ? p.y() : p.x(); };
    auto const bound = [&](Vec2 const& p) { return steep ? p.x() : p.y(); };
    double const middle = 0.5 * (free(a) + free(b)), half = 0.5 * (free(b) - free(a));
    Eigen::MatrixXd powers(static_cast<Eigen::Index>(points.size()), degree + 1);
    Eigen::VectorXd right(static_cast<Eigen::Index>(points.size()));
    for (Eigen::Index i = 0; i < right.size(); ++i) {
        Vec2 const& p = points[static_cast<std::size_t>(i)];
        double const s = (free(p) - middle) / half;
        right[i] = bound(p);
        double power = 1;
        for (Eigen::Index k = 0; k <= degree; ++k, power *= s)
            powers(i, k) = power;
    }
    Eigen::VectorXd const c = numeric::LeastSquares(powers).solve(right);
    constexpr int places = 400;
    std::vector<Vec2> curve;
    for (int i = 0; i <= places; ++i) {
        double const s = -1 + 2.0 * i / places;
        double value = 0;
        for (Eigen::Index k = c.size(); k-- > 0;)
            value = value * s + c[k];
        double const at = middle + half * s;
        curve.push_back(steep ? Vec2(value, at) : Vec2(at, value));
    }
    return curve;
}

double GridAndFit::secant_root(profile::PieceShape const& shape, PlanarVelocity const& twist, double t)
{
    auto const f = [&](double at) {
        ++evaluations;
        OnPiece const on = on_piece(shape, at);
        return on.n.dot(twist(on.x));
    };
    constexpr double first_step = 0x1p-10, enough = 0x1p-40;
    double a = t - first_step, fa = f(a), b = t;
    constexpr int budget = 30;
    for (int k = 0; k < budget; ++k) {
        double const fb = f(b);
        if (fb == 0)
            return b;
        if (fb == fa)
            break;
        double const next = b - fb * (b - a) / (fb - fa);
        a = b;
        fa = fb;
        b = next;
        if (std::abs(b - a) < enough)
            return b;
    }
    return std::abs(b - a) < rounding_of_t ? b : not_measured;  // where rounding has the last word
}

}  // namespace hdconj::accuracy
