// SPDX-License-Identifier: GPL-3.0-or-later
// How an outline is made of points: equal steps of u, the adaptive sampler, and the thesis' grid, iteration and polynomial fit.
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <variant>

#include "bench.hpp"
#include "hdconj/envelope/sample.hpp"
#include "hdconj/motion/first_order_motion.hpp"

namespace hdconj::detail {
namespace {

/// Points of the boundary without its lands: those of @p sampled for each piece, neighbours sharing their common one.
template<class Sampled>
std::vector<Vec2> boundary_points(StudyDrive const& drive, Sampled const& sampled)
{
    std::vector<Vec2> all;
    bool joined = false;
    for (BoundaryPiece const& piece : drive.pieces)
    {
        if (piece.arc < 0)
        {
            joined = false;   // the tip land of a tooth is one chord
            continue;
        }
        std::vector<Vec2> points = sampled(piece);
        for (Vec2& p : points)
            p = drive.placed(piece, p);
        all.insert(all.end(), points.begin() + (joined ? 1 : 0), points.end());
        joined = true;
    }
    return all;
}

/// Calls @p use with what gives the envelope of a piece: compiled for the exact motion where that is the model, since what is measured is its speed.
template<class Use>
auto with_envelopes(StudyDrive const& drive, Use const& use)
{
    if (drive.exact && !drive.reverse())
        return use([&](BoundaryPiece const&) { return Envelope<StudyExactMotion>(drive.tooth, *drive.exact, drive.offset); });
    return use([&](BoundaryPiece const& piece) { return drive.envelope(piece); });
}

/// Every piece with its own ends and the grid points between them.
template<class EnvelopeOf>
std::vector<Vec2> uniform_points(StudyDrive const& drive, EnvelopeOf const& envelope_of, long count)
{
    double const step = 2 * drive.motion().half_lobe() / static_cast<double>(count);
    return boundary_points(drive, [&](BoundaryPiece const& piece) {
        ContactArc const& arc = drive.arc(piece);
        auto const envelope = envelope_of(piece);
        std::vector<Vec2> points{envelope.point(arc, piece.begin).p};
        bool const up = piece.end > piece.begin;
        double const a = std::min(piece.begin, piece.end) / step, b = std::max(piece.begin, piece.end) / step;
        auto const first = static_cast<long>(std::floor(a)) + 1, last = static_cast<long>(std::ceil(b)) - 1;
        for (long k = 0; k <= last - first; ++k)
            points.push_back(envelope.point(arc, step * static_cast<double>(up ? first + k : last - k)).p);
        points.push_back(envelope.point(arc, piece.end).p);
        return points;
    });
}

/// What the adaptive sampler makes of the boundary.
struct AdaptivePoints
{
    std::vector<Vec2> points;
    std::size_t evaluations = 0;
    double estimate = 0;
};

template<class EnvelopeOf>
AdaptivePoints adaptive_points(StudyDrive const& drive, EnvelopeOf const& envelope_of, double chord)
{
    AdaptivePoints made;
    made.points = boundary_points(drive, [&](BoundaryPiece const& piece) {
        SampledArc const sampled = sample_arc(envelope_of(piece), drive.arc(piece), piece.begin, piece.end, chord, 1);
        made.evaluations += sampled.evaluations;
        made.estimate = std::max({made.estimate, sampled.chord, sampled.error});
        std::vector<Vec2> points;
        for (EnvelopePoint const& e : sampled.points)
            points.push_back(e.p);
        return points;
    });
    return made;
}

StudyRecord sampling_record(char const* method, char const* knob, double value)
{
    StudyRecord record;
    record.study = "sampling";
    record.method = method;
    record.knob = knob;
    record.value = value;
    return record;
}

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

void study_sampling(StudyBench const& bench)
{
    StudyDrive const& drive = bench.drive;
    ReferenceCurve const truth = bench.reference.inner();
    constexpr int first = 8, last = 20, last_of_sample = 16, last_of_quick = 13;
    for (int power = first; power <= (bench.quick ? last_of_quick : bench.sampled ? last_of_sample : last); power += 2)
    {
        long const count = 1L << power;
        auto const make = [&] { return with_envelopes(drive, [&](auto const& envelope_of) { return uniform_points(drive, envelope_of, count); }); };
        std::vector<Vec2> const points = make();
        StudyRecord record = sampling_record("equal steps of u", "steps over the lobe", static_cast<double>(count));
        CurveDifference const difference = truth.compare(points, drive.height());
        record.error = difference.points;
        record.hausdorff = difference.hausdorff;
        record.evaluations = record.points = static_cast<double>(points.size());
        bench.measure(record, [&] { (void)make(); });
    }
    constexpr int coarsest = 3, finest = 10, finest_of_sample = 8, finest_of_quick = 6;
    for (int digits = coarsest; digits <= (bench.quick ? finest_of_quick : bench.sampled ? finest_of_sample : finest); ++digits)
    {
        double const chord = power_of_ten(digits);
        auto const make = [&] { return with_envelopes(drive, [&](auto const& envelope_of) { return adaptive_points(drive, envelope_of, chord); }); };
        AdaptivePoints const made = make();
        StudyRecord record = sampling_record("adaptive", "chord", chord);
        CurveDifference const difference = truth.compare(made.points, drive.height());
        record.error = difference.points;
        record.hausdorff = difference.hausdorff;
        record.estimate = made.estimate;
        record.evaluations = static_cast<double>(made.evaluations);
        record.points = static_cast<double>(made.points.size());
        bench.measure(record, [&] { (void)make(); });
    }
}

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
