// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Both flanks of a solved drive as the second problem is given them: the flexspline's as the program builds it, the
/// circular spline's by the oracle in long double, as polynomials through its exact contacts.
#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "cam/march.hpp"
#include "drive/drive.hpp"
#include "hdconj/motion/any_motion.hpp"
#include "hdconj/motion/exact_motion.hpp"
#include "hdconj/motion/first_order_motion.hpp"
#include "hdconj/units.hpp"
#include "support/oracle/run.hpp"
#include "support/oracle/touch.hpp"

namespace given_flanks {

using hdconj::Vec2;
/// Long double suffices: an error of the normal moves a contact along the envelope, and away from it by its square
/// only.
using Number = long double;

/// A stretch of the mesh that one piece of the flexspline's right flank makes.
struct Stretch
{
    hdconj::profile::PieceShape shape;  ///< line or arc
    std::vector<double> cuts;           ///< of the parameter of the motion, between which one polynomial stands [rad]
};

/// The motion whose contacts are wanted: places by the oracle, directions by the program.
struct BothMotions
{
    oracle::Motion<Number> const& places;
    hdconj::motion::AnyMotion directions;
};

/// The contact of @p shape at @p s in the frame of the circular spline: on an arc the normal is perpendicular to the
/// velocity of its centre, on a line the velocity along the normal is linear. An error of the velocity moves a contact
/// along the envelope, and away from it by its square only; a difference quotient would reach over breaks of a cam.
inline oracle::Point<Number> contact(BothMotions const& motion, hdconj::profile::PieceShape const& shape,
                                     Number const& s)
{
    oracle::Pose<Number> const pose = motion.places.pose(s);
    hdconj::PlanarVelocity const velocity = motion.directions.rates(static_cast<double>(s)).twist;
    auto const point = [](Vec2 const& p) { return oracle::Point<Number>{p.x(), p.y()}; };
    if (auto const* arc = std::get_if<hdconj::profile::ArcPiece>(&shape)) {
        Vec2 n = hdconj::left_of(velocity(arc->centre)).normalized();
        if (n.dot(hdconj::direction((arc->from + arc->to) / 2)) < 0)
            n = -n;
        auto const normal = point(n);
        auto const on_circle = (Number(arc->radius) / oracle::length(normal)) * normal;
        return pose.to_circular_spline(point(arc->centre) + on_circle);
    }
    auto const& line = std::get<hdconj::profile::LinePiece>(shape);
    Vec2 const n = line.normal();
    Number const a = n.dot(velocity(line.a)), b = n.dot(velocity(line.b));
    return pose.to_circular_spline(point(line.a) + (a / (a - b)) * (point(line.b) - point(line.a)));
}

/// Polynomial of degree 9 through contacts at Chebyshev's nodes between @p a and @p b, in the frame @p seat, whose
/// origin is told from (0, r_m).
inline hdconj::profile::CurvePiece envelope_piece(BothMotions const& motion, hdconj::profile::PieceShape const& shape,
                                                  double a, double b, double r_m, hdconj::Pose const& seat)
{
    constexpr int degree = 9;
    Eigen::Matrix<Number, degree + 1, degree + 1> basis;
    Eigen::Matrix<Number, degree + 1, 2> right;
    for (int i = 0; i <= degree; ++i) {
        Number const t = (1 - std::cos(std::numbers::pi_v<Number> * (2 * i + 1) / (2 * (degree + 1)))) / 2;
        auto const p = contact(motion, shape, Number(a) + Number(b - a) * Number(t));
        Number const x = p.x - seat.origin.x();
        Number const y = (p.y - Number(r_m)) - seat.origin.y();
        right(i, 0) = seat.cosine * x - seat.sine * y;
        right(i, 1) = seat.sine * x + seat.cosine * y;
        Number binomial = 1;
        for (int k = 0; k <= degree; ++k) {
            basis(i, k) =
                binomial * std::pow(t, static_cast<Number>(k)) * std::pow(1 - t, static_cast<Number>(degree - k));
            binomial = binomial * (degree - k) / (k + 1);
        }
    }
    Eigen::Matrix<Number, degree + 1, 2> const solved = basis.fullPivLu().solve(right);
    std::vector<double> xs, ys;
    for (int k = 0; k <= degree; ++k) {
        xs.push_back(static_cast<double>(solved(k, 0)));
        ys.push_back(static_cast<double>(solved(k, 1)));
    }
    return {std::move(xs), std::move(ys)};
}

/// The longest run of conjugate zones of the right flank that bound the space, one after the other in time.
inline std::vector<Stretch> longest_run(hdconj::Solution const& solution, hdconj::profile::Profile const& tooth,
                                        std::vector<double> const& breaks)
{
    std::vector<hdconj::ConjugateZone> zones;
    for (auto const& zone : solution.zones)
        if (zone.on_boundary && zone.kind == "regular" && zone.segment_name.starts_with("right"))
            zones.push_back(zone);
    bool const exact = solution.scene.solver.kinematics == hdconj::Kinematics::exact;
    auto const ends = [exact](auto const& zone) {
        return exact ? std::minmax(zone.u_begin, zone.u_end) : std::minmax(zone.phi_begin, zone.phi_end);
    };
    std::sort(zones.begin(), zones.end(), [&](auto const& p, auto const& q) { return ends(p).first < ends(q).first; });
    std::vector<Stretch> best;
    double best_length = 0;
    for (std::size_t first = 0; first < zones.size(); ++first) {
        std::vector<Stretch> run;
        double const begin = ends(zones[first]).first;
        double reached = begin;
        for (std::size_t i = first; i < zones.size(); ++i) {
            auto const [low, high] = ends(zones[i]);
            // where the mesh is just beginning or ending contact runs fast along the flank: short polynomials
            auto const piece = std::find_if(tooth.pieces.begin(), tooth.pieces.end(), [&](auto const& p) {
                return p.segment == zones[i].segment && !p.corner &&
                       !std::holds_alternative<hdconj::profile::CurvePiece>(p.shape);
            });
            if (piece == tooth.pieces.end() || std::abs(low - reached) > 1e-9 || low < 0)
                continue;
            std::vector<double> cuts;
            constexpr double shortest = 0.01 * hdconj::deg, longest = 2 * hdconj::deg, growth = 1.25;
            for (double x = low, width = shortest; x < (low + high) / 2;
                 x += width, width = std::min(width * growth, longest)) {
                cuts.push_back(x);
                cuts.push_back(low + high - x);
            }
            for (double const b : breaks)
                if (b > low && b < high)
                    cuts.push_back(b);
            std::sort(cuts.begin(), cuts.end());
            cuts.erase(std::unique(cuts.begin(), cuts.end(), [](double p, double q) { return q - p < 1e-9; }),
                       cuts.end());
            run.push_back({piece->shape, cuts});
            reached = high;
        }
        if (reached - begin > best_length) {
            best_length = reached - begin;
            best = run;
        }
    }
    return best;
}

/// A drive, its known curve, and both flanks.
struct GivenFlanks
{
    hdconj::cam::CurveRule rule;
    hdconj::cam::FlankPair pair;
    double begin = 0;  ///< of the mesh [rad]
    double end = 0;
};

/// @returns nothing where no flank of lines and arcs bounds the space
inline std::optional<GivenFlanks> flanks_of(hdconj::Solution const& solution, oracle::Motion<Number> const& places)
{
    hdconj::Faults faults;
    hdconj::Scene const& scene = solution.scene;
    hdconj::profile::Profile const tooth = hdconj::drive::given_tooth(scene, faults);
    auto const shape = hdconj::drive::wave_shape(scene, tooth, faults);
    std::vector<Stretch> const run = longest_run(solution, tooth, {shape.breaks().begin(), shape.breaks().end()});
    if (run.empty())
        return std::nullopt;
    double const r_m = solution.geometry.r_m;
    double const ratio = static_cast<double>(scene.drive.flexspline_teeth) / scene.drive.circular_spline_teeth;
    bool const exact = scene.solver.kinematics == hdconj::Kinematics::exact;
    using hdconj::motion::AnyMotion;
    using Shape = hdconj::wavegen::AnyWaveShape;
    BothMotions const motion{places,
                             exact ? AnyMotion::owning(hdconj::motion::ExactMotion<Shape>({shape, r_m}, ratio))
                                   : AnyMotion::owning(hdconj::motion::FirstOrderMotion<Shape>(shape, r_m, ratio))};
    // about the middle of the tooth's height
    double const height = solution.geometry.pitch_line + solution.geometry.w0;
    hdconj::Pose const seat =
        hdconj::cam::right_wall(std::numbers::pi / scene.drive.circular_spline_teeth, r_m, height);
    hdconj::profile::Profile inner, outer;
    for (Stretch const& stretch : run) {
        for (std::size_t i = 0; i + 1 < stretch.cuts.size(); ++i)
            outer.pieces.push_back(
                {envelope_piece(motion, stretch.shape, stretch.cuts[i], stretch.cuts[i + 1], r_m, seat), 0, 0, 1,
                 false});
    }
    // the wall's outward normal looks against the flank's
    auto const flank_normal = hdconj::profile::start_of(run.front().shape).normal;
    if (seat.rotate(hdconj::profile::start_of(outer.pieces.front().shape).normal).dot(flank_normal) > 0) {
        std::reverse(outer.pieces.begin(), outer.pieces.end());
        for (auto& piece : outer.pieces) {
            auto const& curve = std::get<hdconj::profile::CurvePiece>(piece.shape);
            piece.shape = hdconj::profile::CurvePiece({curve.x().rbegin(), curve.x().rend()},
                                                      {curve.y().rbegin(), curve.y().rend()});
        }
    }
    // a run may go along one piece twice, and against the order of the tooth
    for (auto const& piece : tooth.pieces) {
        bool const used = std::any_of(run.begin(), run.end(), [&](Stretch const& stretch) {
            return hdconj::profile::start_of(stretch.shape).point == hdconj::profile::start_of(piece.shape).point;
        });
        if (used && !piece.corner)
            inner.pieces.push_back(piece);
    }
    inner.addendum = outer.addendum = 1e3 * r_m;  // nothing is a tip
    return GivenFlanks{{r_m, ratio, exact},
                       {hdconj::cam::Flank(inner), hdconj::cam::Flank(outer), seat},
                       run.front().cuts.front(),
                       run.back().cuts.back()};
}

/// The curve of a solved drive by the oracle.
class KnownCurve
{
  public:
    KnownCurve(hdconj::Scene const& scene, double r_m) : motion(scene), cam_(scene, Number(r_m)) {}

    [[nodiscard]] hdconj::cam::CurveState state(double x) const
    {
        Number const s = x, w = cam_(s).w, r_m = motion.r_m;
        bool const exact = motion.exact;
        return {static_cast<double>(exact ? motion.r_0 - r_m + w : w),
                static_cast<double>(r_m * ((exact ? motion.phi(s) : motion.u(s)) - s))};
    }
    [[nodiscard]] hdconj::cam::MeshPoint point(hdconj::cam::CurveRule const& rule, double x) const
    {
        hdconj::cam::MeshPoint at{x, state(x), static_cast<double>(cam_(Number(x)).slope), {}};
        at.contact.theta = rule.theta(rule.origin(x, at.state), at.slope);
        return at;
    }

    oracle::Motion<Number> motion;

  private:
    oracle::Cam<Number> cam_;
};

/// Rounding of a tooth [mm].
inline double rounding_of(hdconj::Scene const& scene)
{
    return 8 * hdconj::unit_roundoff * scene.drive.module;
}

}  // namespace given_flanks
