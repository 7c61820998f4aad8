// SPDX-License-Identifier: GPL-3.0-or-later
// A flank as the thesis makes it: a grid in phi, iteration, a polynomial fit.
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "bench.hpp"
#include "hdconj/envelope/contact.hpp"
#include "hdconj/motion/first_order_motion.hpp"
#include "hdconj/study/ladder.hpp"

namespace hdconj::detail {
namespace {

/// The flank stretch of the boundary, on the side of larger x, that is longest.
BoundaryPiece const* longest_flank(StudyBench const& bench)
{
    BoundaryPiece const* longest = nullptr;
    double most = 0;
    for (std::size_t i = bench.drive.pieces.size() / 2; i < bench.drive.pieces.size(); ++i)
    {
        BoundaryPiece const& piece = bench.drive.pieces[i];
        double const length = bench.reference.length(static_cast<int>(i));
        if (bench.drive.is_flank(piece) && length > most)
        {
            most = length;
            longest = &piece;
        }
    }
    return longest;
}

constexpr double rounding_of_t = 0x1p-30;   ///< an end of a flank is met so closely
constexpr double same_contact = 0x1p-20;    ///< of profile parameters: well above what the secant rule leaves, well below the distance of two contacts

/// Local point and unit normal of a piece.
struct OnPiece
{
    Vec2 x, n;
};
OnPiece on_piece(PieceShape const& shape, double t)
{
    if (auto const* arc = std::get_if<ArcPiece>(&shape))
    {
        Vec2 const n = direction(arc->from + t * (arc->to - arc->from));
        return {arc->centre + arc->radius * n, n};
    }
    if (auto const* line = std::get_if<LinePiece>(&shape))
        return {line->a + t * (line->b - line->a), line->normal()};
    auto const& curve = std::get<CurvePiece>(shape);
    return {curve.point(t), left_of(curve.first(t)).normalized()};
}

/// Of the contacts of a piece at an instant, the one nearest to @p wanted; not_measured where none is within its ends.
double nearest_contact(PieceShape const& shape, MotionRates const& rates, double wanted)
{
    double nearest = not_measured;
    auto const take = [&](double t) {
        if (t >= -rounding_of_t && t <= 1 + rounding_of_t && !(std::abs(nearest - wanted) <= std::abs(t - wanted)))
            nearest = t;
    };
    if (auto const* arc = std::get_if<ArcPiece>(&shape))
    {
        take(arc_contact(*arc, rates, 1, 0).t);
        take(arc_contact(*arc, rates, -1, 0).t);
    }
    else if (auto const* line = std::get_if<LinePiece>(&shape))
        take(line_contact(*line, rates, 0).t);
    else
    {
        BernsteinRoots const roots = curve_contacts(std::get<CurvePiece>(shape), rates.twist);
        for (int i = 0; i < roots.count; ++i)
            take(roots.t[static_cast<std::size_t>(i)]);
    }
    return nearest;
}

/// Points of a flank at the steps of a grid.
struct GridPoints
{
    std::vector<Vec2> points;
    std::vector<int> steps;   ///< of the grid that each of them is of
    int missed = 0;           ///< steps without a point: the motion has no contact on the flank, or the iteration left it or did not converge, or found another contact
    int extra = 0;            ///< such other contacts of the flank, taken for this one
};

/// A flank as the thesis makes it.
class GridAndFit
{
  public:
    std::size_t evaluations = 0;

    /// Contacts at @p count equal steps of the motion's parameter: the profile parameter by the secant rule from the one before.
    /// What the iteration takes for a contact, converged and on its flank, is compared with @p contacts, NaN where there is none.
    template<RelativeMotion Motion>
    GridPoints points(StudyDrive const& drive, Motion const& motion, BoundaryPiece const& piece, double from, double to, std::vector<double> const& contacts)
    {
        auto const count = static_cast<int>(contacts.size());
        ContactArc const& arc = drive.arc(piece);
        PieceShape const& shape = drive.tooth.pieces[static_cast<std::size_t>(arc.piece)].shape;
        double t = piece.begin == arc.u_begin ? arc.t_begin : piece.begin == arc.u_end ? arc.t_end : drive.envelope(piece).point(arc, piece.begin).t;
        GridPoints result;
        for (int i = 0; i < count; ++i)
        {
            double const s = from + (to - from) * i / (count - 1);
            double const found = secant_root(shape, motion.rates(s).twist, t), right = contacts[static_cast<std::size_t>(i)];
            bool const kept = found >= -rounding_of_t && found <= 1 + rounding_of_t;   // the method sees as much itself, and begins the next step with what it kept
            if (kept)
                t = found;
            if (!kept || !(std::abs(found - right) <= same_contact))
            {
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

    /// The polynomial of @p degree through points by least squares, radius against angle or the other way round, whichever changes more; its curve at 400 places.
    static std::vector<Vec2> fitted(std::vector<Vec2> const& points, int degree)
    {
        Vec2 const a = points.front(), b = points.back();
        bool const steep = std::abs(b.y() - a.y()) > std::abs(b.x() - a.x());
        auto const free = [&](Vec2 const& p) { return steep ? p.y() : p.x(); };
        auto const bound = [&](Vec2 const& p) { return steep ? p.x() : p.y(); };
        double const middle = 0.5 * (free(a) + free(b)), half = 0.5 * (free(b) - free(a));
        Eigen::MatrixXd powers(static_cast<Eigen::Index>(points.size()), degree + 1);
        Eigen::VectorXd right(static_cast<Eigen::Index>(points.size()));
        for (Eigen::Index i = 0; i < right.size(); ++i)
        {
            Vec2 const& p = points[static_cast<std::size_t>(i)];
            double const s = (free(p) - middle) / half;
            right[i] = bound(p);
            double power = 1;
            for (Eigen::Index k = 0; k <= degree; ++k, power *= s)
                powers(i, k) = power;
        }
        Eigen::VectorXd const c = powers.colPivHouseholderQr().solve(right);
        constexpr int places = 400;
        std::vector<Vec2> curve;
        for (int i = 0; i <= places; ++i)
        {
            double const s = -1 + 2.0 * i / places;
            double value = 0;
            for (Eigen::Index k = c.size(); k-- > 0;)
                value = value * s + c[k];
            double const at = middle + half * s;
            curve.push_back(steep ? Vec2(value, at) : Vec2(at, value));
        }
        return curve;
    }

  private:
    /// NaN where it does not converge.
    double secant_root(PieceShape const& shape, Twist const& twist, double t)
    {
        auto const f = [&](double at) {
            ++evaluations;
            OnPiece const on = on_piece(shape, at);
            return on.n.dot(twist(on.x));
        };
        constexpr double first_step = 0x1p-10, enough = 0x1p-40;
        double a = t - first_step, fa = f(a), b = t;
        constexpr int budget = 30;
        for (int k = 0; k < budget; ++k)
        {
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
        return std::abs(b - a) < rounding_of_t ? b : not_measured;   // where rounding has the last word
    }
};

/// Profile parameters of the contacts of @p motion at @p count equal steps from @p from to @p to: of @p piece itself where that is the drive's motion, else of the contact of that motion nearest to it.
template<RelativeMotion Motion>
std::vector<double> contacts_of(StudyDrive const& drive, Motion const& motion, BoundaryPiece const& piece, double from, double to, int count, bool own)
{
    ContactArc const& arc = drive.arc(piece);
    PieceShape const& shape = drive.tooth.pieces[static_cast<std::size_t>(arc.piece)].shape;
    std::vector<double> contacts;
    for (int i = 0; i < count; ++i)
    {
        double const share = static_cast<double>(i) / (count - 1);
        double const there = drive.envelope(piece).point(arc, i == count - 1 ? piece.end : piece.begin + share * (piece.end - piece.begin)).t;
        contacts.push_back(own ? there : nearest_contact(shape, motion.rates(from + share * (to - from)), there));
    }
    return contacts;
}

/// A motion, and where it has the stretch that is fitted.
template<RelativeMotion Motion>
struct FittedMotion
{
    Motion const& motion;
    double from, to;
    char const* model;
    bool own;   ///< that of the drive
};

template<RelativeMotion Motion>
void fit_ladders(StudyBench const& bench, ReferenceCurve const& truth, BoundaryPiece const& piece, FittedMotion<Motion> const& fitted)
{
    StudyRecord record;
    record.study = "polynomial-fit";
    constexpr int least = 3, most = 9, of_quick = 6, positions = 60;
    auto const contacts = [&](int count) { return contacts_of(bench.drive, fitted.motion, piece, fitted.from, fitted.to, count, fitted.own); };
    auto const points = [&](GridAndFit& thesis, std::vector<double> const& there) { return thesis.points(bench.drive, fitted.motion, piece, fitted.from, fitted.to, there); };
    record.method = std::string("fit, ") + fitted.model;
    record.knob = polynomial_degree;
    std::vector<double> const few = contacts(positions);
    for (int degree = least; degree <= (bench.quick ? of_quick : most); ++degree)
    {
        GridAndFit thesis;
        GridPoints const grid = points(thesis, few);
        bool const enough = static_cast<int>(grid.points.size()) > degree;
        record.value = degree;
        record.error = record.hausdorff = enough ? truth.largest_distance(GridAndFit::fitted(grid.points, degree)) : not_measured;
        record.missed = grid.missed;
        record.extra = grid.extra;
        record.evaluations = static_cast<double>(thesis.evaluations);
        record.points = static_cast<double>(grid.points.size());
        bench.measure(record, [&] {
            GridPoints const again = points(thesis, few);
            if (enough)
                (void)GridAndFit::fitted(again.points, degree);
        });
    }
    record.method = std::string("points joined, ") + fitted.model;
    record.knob = "grid points";
    constexpr int finest = 2000, finest_of_quick = 200;
    for (int count = 10; count <= (bench.quick ? finest_of_quick : finest); count = count * 2 + count % 3)
    {
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
        record.missed = grid.missed;
        record.extra = grid.extra;
        record.evaluations = static_cast<double>(thesis.evaluations);
        record.points = static_cast<double>(grid.points.size());
        bench.measure(record, [&] { (void)points(thesis, there); });
    }
}

}  // namespace

void study_fit(StudyBench const& bench)
{
    BoundaryPiece const* piece = longest_flank(bench);
    if (piece == nullptr)
    {
        bench.leave_out("polynomial-fit", "no flank of the tooth bounds the tooth space, so there is nothing to fit");
        return;
    }
    StudyDrive const& drive = bench.drive;
    // a little longer than the stretch, since the first-order flank does not end where the exact one does; an arc's contact goes on beyond its end
    BoundaryPiece longer = *piece;
    bool const closed_form = !std::holds_alternative<CurvePiece>(drive.tooth.pieces[static_cast<std::size_t>(drive.arc(*piece).piece)].shape);
    double const more = closed_form ? (piece->end - piece->begin) / 16 : 0;
    longer.begin -= more;
    longer.end += more;
    ReferenceCurve const truth = reference_of(drive, longer);
    // the motion of the scene, and where that is the exact one the thesis' own beside it
    char const* const model = drive.scene.solver.kinematics == Kinematics::exact ? "exact motion" : drive.scene.solver.kinematics == Kinematics::material ? "material" : "first order";
    auto const own = [&](auto const& motion) { fit_ladders(bench, truth, *piece, FittedMotion<std::decay_t<decltype(motion)>>{motion, piece->begin, piece->end, model, true}); };
    if (!drive.exact)
        return own(drive.motion(*piece));
    if (drive.reverse())
        own(drive.motion(*piece));
    else
        own(*drive.exact);
    FirstOrderMotion<AnyWaveShape> const first(drive.shape, drive.geometry.r_m,
                                               static_cast<double>(drive.scene.drive.flexspline_teeth) / drive.scene.drive.circular_spline_teeth);
    auto const phi = [&](double u) { return drive.motion().angles(u).phi; };
    auto const thesis = [&](auto const& motion) {
        fit_ladders(bench, truth, *piece, FittedMotion<std::decay_t<decltype(motion)>>{motion, phi(piece->begin), phi(piece->end), "first order", false});
    };
    if (drive.reverse())
        thesis(StudyMotion(first).seen_from_flexspline(drive.numbers[drive.tooth_of(*piece)], drive.pitch, drive.seat_radius));
    else
        thesis(first);
}

}  // namespace hdconj::detail
