// SPDX-License-Identifier: GPL-3.0-or-later
// A flank as the thesis makes it: a grid in phi, iteration, a polynomial fit.
#include <cmath>
#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "conjugate/plane/plane_motion.hpp"
#include "convergence_series.hpp"
#include "hdconj/accuracy.hpp"
#include "hdconj/envelope/contact.hpp"
#include "hdconj/motion/first_order_motion.hpp"
#include "numeric/least_squares.hpp"
#include "study_bench.hpp"
#include "study_drive.hpp"

namespace hdconj::accuracy {
namespace {

/// Distance of profile parameters at which an end of a flank counts as met.
constexpr double rounding_of_t = 0x1p-30;

/// Distance of profile parameters of one contact: well above the remainder of the secant rule, well below the distance
/// of two contacts.
constexpr double same_contact = 0x1p-20;

/// Local point and unit normal of a piece.
struct OnPiece
{
    Vec2 x, n;
};

/// @param t  profile parameter, 0 ... 1 on the piece
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

/// Points of a flank at the steps of a grid.
struct GridPoints
{
    std::vector<Vec2> points;
    std::vector<int> steps;  ///< of the grid that each of them is of
    int missed = 0;  ///< steps without a point: the motion has no contact on the flank, or the iteration left the
                     ///< flank, did not converge or found another contact
    int extra = 0;   ///< steps at which it found another contact
};

/// The method of the thesis; it counts its evaluations of the meshing condition.
class GridAndFit
{
  public:
    std::size_t evaluations = 0;

    /// Contacts at equal steps of the motion's parameter. The secant rule finds each profile parameter from the one
    /// before. A converged value on the flank is compared with the entry of @p contacts, NaN where there is no contact.
    GridPoints points(StudyDrive const& drive, motion::AnyMotion const& motion, conjugate::BoundaryPiece const& piece,
                      double from, double to, std::vector<double> const& contacts)
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

  private:
    /// NaN where it does not converge.
    [[nodiscard]] double secant_root(profile::PieceShape const& shape, PlanarVelocity const& twist, double t)
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
};

/// Fits a polynomial of @p degree by least squares, x against y or y against x, whichever of them varies more as
/// the free variable. @returns 401 points of its curve
std::vector<Vec2> fitted_curve(std::vector<Vec2> const& points, int degree)
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

/// Of the contacts of a piece at an instant, the one nearest to @p wanted; not_measured where none is within its ends.
double nearest_contact(profile::PieceShape const& shape, motion::MotionRates const& rates, double wanted)
{
    double nearest = not_measured;
    auto const take = [&](double t) {
        if (t >= -rounding_of_t && t <= 1 + rounding_of_t && !(std::abs(nearest - wanted) <= std::abs(t - wanted)))
            nearest = t;
    };
    if (auto const* arc = std::get_if<profile::ArcPiece>(&shape)) {
        take(envelope::arc_contact(*arc, rates, 1, 0).t);
        take(envelope::arc_contact(*arc, rates, -1, 0).t);
    } else if (auto const* line = std::get_if<profile::LinePiece>(&shape))
        take(envelope::line_contact(*line, rates, 0).t);
    else {
        numeric::BernsteinRoots const roots =
            envelope::curve_contacts(std::get<profile::CurvePiece>(shape), rates.twist);
        for (int i = 0; i < roots.count; ++i)
            take(roots.t[static_cast<std::size_t>(i)]);
    }
    return nearest;
}

/// Profile parameters of the contacts of @p motion at @p count equal steps from @p from to @p to: of @p piece itself
/// where that is the drive's motion, else of the contact of that motion nearest to it.
std::vector<double> contacts_of(StudyDrive const& drive, motion::AnyMotion const& motion,
                                conjugate::BoundaryPiece const& piece, double from, double to, int count, bool own)
{
    envelope::ContactArc const& arc = drive.arc(piece);
    profile::PieceShape const& shape = drive.shape_of(piece);
    std::vector<double> contacts;
    for (int i = 0; i < count; ++i) {
        double const share = static_cast<double>(i) / (count - 1);
        double const there =
            drive.envelope(piece)
                .point(arc, i == count - 1 ? piece.end : piece.begin + share * (piece.end - piece.begin))
                .t;
        contacts.push_back(own ? there : nearest_contact(shape, motion.rates(from + share * (to - from)), there));
    }
    return contacts;
}

/// A motion, and where it has the stretch that is fitted.
struct FittedMotion
{
    motion::AnyMotion motion;
    double from, to;
    char const* model;
    bool own;  ///< that of the drive
};

void fit_series(StudyBench const& bench, ReferenceCurve const& truth, conjugate::BoundaryPiece const& piece,
                FittedMotion const& fitted)
{
    StudyRecord record{"polynomial-fit", {}, std::string("fit, ") + fitted.model, polynomial_degree};
    constexpr int least = 3, most = 9, of_quick = 6, positions = 60;
    auto const contacts = [&](int count) {
        return contacts_of(bench.drive, fitted.motion, piece, fitted.from, fitted.to, count, fitted.own);
    };
    auto const points = [&](GridAndFit& thesis, std::vector<double> const& there) {
        return thesis.points(bench.drive, fitted.motion, piece, fitted.from, fitted.to, there);
    };
    auto const take = [&](GridPoints const& grid, GridAndFit const& thesis) {
        record.missed = grid.missed;
        record.extra = grid.extra;
        record.evaluations = static_cast<double>(thesis.evaluations);
        record.points = static_cast<double>(grid.points.size());
    };
    std::vector<double> const few = contacts(positions);
    for (int degree = least; degree <= (bench.quick ? of_quick : most); ++degree) {
        GridAndFit thesis;
        GridPoints const grid = points(thesis, few);
        bool const enough = static_cast<int>(grid.points.size()) > degree;
        record.value = degree;
        record.error = record.hausdorff =
            enough ? truth.largest_distance(fitted_curve(grid.points, degree)) : not_measured;
        take(grid, thesis);
        bench.measure(record, [&] {
            GridPoints const again = points(thesis, few);
            if (enough)
                (void)fitted_curve(again.points, degree);
        });
    }
    record.method = std::string("points joined, ") + fitted.model;
    record.knob = "grid points";
    constexpr int finest = 2000, finest_of_quick = 200;
    for (int count = 10; count <= (bench.quick ? finest_of_quick : finest); count = count * 2 + count % 3) {
        GridAndFit thesis;
        std::vector<double> const there = contacts(count);
        GridPoints const grid = points(thesis, there);
        std::vector<Vec2> with_chords;
        for (std::size_t i = 0; i + 1 < grid.points.size(); ++i)
            if (grid.steps[i + 1] == grid.steps[i] + 1)
                for (double const share : {0.0, 0.25, 0.5, 0.75})
                    with_chords.push_back(grid.points[i] + share * (grid.points[i + 1] - grid.points[i]));
        bool const some = !with_chords.empty();
        record.value = count;
        record.error = some ? truth.largest_distance(grid.points) : not_measured;
        record.hausdorff = some ? truth.largest_distance(with_chords) : not_measured;
        take(grid, thesis);
        bench.measure(record, [&] { (void)points(thesis, there); });
    }
}

}  // namespace

void study_fit(StudyBench const& bench)
{
    conjugate::BoundaryPiece const* piece = longest_flank(bench, [](auto const&) { return true; });
    if (piece == nullptr)
        return bench.leave_out("polynomial-fit",
                               "no flank of the tooth bounds the tooth space, so there is nothing to fit");
    StudyDrive const& drive = bench.drive;
    // a little longer than the stretch, since the first-order flank does not end where the exact one does; an arc's
    // contact goes on beyond its end
    conjugate::BoundaryPiece longer = *piece;
    bool const closed_form = !std::holds_alternative<profile::CurvePiece>(drive.shape_of(*piece));
    double const more = closed_form ? (piece->end - piece->begin) / 16 : 0;
    longer.begin -= more;
    longer.end += more;
    ReferenceCurve const truth = reference_of(drive, longer);
    // the motion of the scene, and where that is the exact one the thesis' own beside it
    char const* const model = drive.scene.solver.kinematics == Kinematics::exact      ? "exact motion"
                              : drive.scene.solver.kinematics == Kinematics::material ? "material"
                                                                                      : "first order";
    fit_series(bench, truth, *piece, {drive.motion(*piece), piece->begin, piece->end, model, true});
    if (drive.scene.solver.kinematics != Kinematics::exact)
        return;
    auto first = motion::AnyMotion::owning(motion::FirstOrderMotion<wavegen::AnyWaveShape>(
        drive.shape, drive.geometry.r_m, conjugate::tooth_ratio(drive.scene)));
    if (drive.reverse())
        first =
            motion::seen_from_flexspline(first, drive.numbers[drive.tooth_of(*piece)], drive.pitch, drive.seat_radius);
    auto const phi = [&](double u) { return drive.motion().angles(u).phi; };
    fit_series(bench, truth, *piece, {first, phi(piece->begin), phi(piece->end), "first order", false});
}

}  // namespace hdconj::accuracy
