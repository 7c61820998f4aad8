// SPDX-License-Identifier: GPL-3.0-or-later
// A flank as the thesis makes it: a grid in phi, iteration, a polynomial fit.
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include "bench.hpp"
#include "hdconj/motion/first_order_motion.hpp"

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

/// A flank as the thesis makes it.
class GridAndFit
{
  public:
    std::size_t evaluations = 0;

    /// Contacts at @p count equal steps of the motion's parameter: the profile parameter by the secant rule from the one before.
    template<RelativeMotion Motion>
    std::vector<Vec2> points(StudyDrive const& drive, Motion const& motion, BoundaryPiece const& piece, double from, double to, int count)
    {
        ContactArc const& arc = drive.arc(piece);
        PieceShape const& shape = drive.tooth.pieces[static_cast<std::size_t>(arc.piece)].shape;
        double t = piece.begin == arc.u_begin ? arc.t_begin : piece.begin == arc.u_end ? arc.t_end : drive.envelope(piece).point(arc, piece.begin).t;
        std::vector<Vec2> result;
        for (int i = 0; i < count; ++i)
        {
            double const s = from + (to - from) * i / (count - 1);
            Twist const twist = motion.rates(s).twist;
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
                if (fb == fa)
                    break;
                double const next = b - fb * (b - a) / (fb - fa);
                a = b;
                fa = fb;
                b = next;
                if (std::abs(b - a) < enough)
                    break;
            }
            t = b;
            OnPiece const on = on_piece(shape, t);
            result.push_back(drive.placed(piece, motion.pose(s)(on.x + drive.offset * on.n)));
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
};

template<RelativeMotion Motion>
void fit_ladders(StudyBench const& bench, ReferenceCurve const& truth, BoundaryPiece const& piece, Motion const& motion, double from, double to,
                 std::string const& model)
{
    StudyRecord record;
    record.study = "polynomial-fit";
    constexpr int least = 3, most = 9, of_quick = 6, positions = 60;
    record.method = "fit, " + model;
    record.knob = "degree";
    for (int degree = least; degree <= (bench.quick ? of_quick : most); ++degree)
    {
        GridAndFit thesis;
        auto const make = [&] { return GridAndFit::fitted(thesis.points(bench.drive, motion, piece, from, to, positions), degree); };
        record.value = degree;
        record.error = record.hausdorff = truth.largest_distance(make());
        record.evaluations = static_cast<double>(thesis.evaluations);
        record.points = positions;
        bench.measure(record, [&] { (void)make(); });
    }
    record.method = "points joined, " + model;
    record.knob = "grid points";
    constexpr int finest = 2000, finest_of_quick = 200;
    for (int count = 10; count <= (bench.quick ? finest_of_quick : finest); count = count * 2 + count % 3)
    {
        GridAndFit thesis;
        auto const make = [&] { return thesis.points(bench.drive, motion, piece, from, to, count); };
        std::vector<Vec2> const points = make();
        std::vector<Vec2> with_chords;
        for (std::size_t i = 0; i + 1 < points.size(); ++i)
            for (double const share : {0.0, 0.25, 0.5, 0.75})
                with_chords.push_back(points[i] + share * (points[i + 1] - points[i]));
        record.value = count;
        record.error = truth.largest_distance(points);
        record.hausdorff = truth.largest_distance(with_chords);
        record.evaluations = static_cast<double>(thesis.evaluations);
        record.points = count;
        bench.measure(record, [&] { (void)make(); });
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
    if (!drive.exact)
        return fit_ladders(bench, truth, *piece, drive.motion(*piece), piece->begin, piece->end, model);
    if (drive.reverse())
        fit_ladders(bench, truth, *piece, drive.motion(*piece), piece->begin, piece->end, model);
    else
        fit_ladders(bench, truth, *piece, *drive.exact, piece->begin, piece->end, model);
    FirstOrderMotion<AnyWaveShape> const first(drive.shape, drive.geometry.r_m,
                                               static_cast<double>(drive.scene.drive.flexspline_teeth) / drive.scene.drive.circular_spline_teeth);
    auto const phi = [&](double u) { return drive.motion().angles(u).phi; };
    if (drive.reverse())
        fit_ladders(bench, truth, *piece, StudyMotion(first).seen_from_flexspline(drive.numbers[drive.tooth_of(*piece)], drive.pitch, drive.seat_radius), phi(piece->begin),
                    phi(piece->end), "first order");
    else
        fit_ladders(bench, truth, *piece, first, phi(piece->begin), phi(piece->end), "first order");
}

}  // namespace hdconj::detail
