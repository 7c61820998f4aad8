// SPDX-License-Identifier: GPL-3.0-or-later
// Tooth families "points" and "b-spline": a cubic spline through points of a file, or of the scene.
#include "measured_points.hpp"

#include <gsl/gsl_bspline.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_linalg.h>
#include <gsl/gsl_version.h>
#include <algorithm>
#include <memory>

#include "base/text.hpp"
#include "families.hpp"
#include "hdconj/error.hpp"
#include "hdconj/scene/number_pairs.hpp"
#include "sound_flank.hpp"

namespace hdconj::profile {
namespace {

constexpr std::size_t spline_order = 4;

template <auto release>
struct Free
{
    void operator()(auto* p) const { release(p); }
};

/// Adds @p p, which stands in @p place, to @p points; a point that repeats the one before is a fault of @p key.
/// @return whether it was added
bool add_point(std::vector<Vec2>& points, Vec2 const& p, scene::FamilyChoice const& c, std::string_view key,
               std::string const& place, Faults& faults)
{
    bool const repeats = !points.empty() && p == points.back();
    if (repeats)
        faults.push_back(
            scene::parameter_fault(c, key, place + " repeats the point before it", "remove the repeated point"));
    else
        points.push_back(p);
    return !repeats;
}

std::vector<Vec2> read_points(scene::FamilyChoice const& c, std::string const& folder, Faults& faults)
{
    std::size_t const before = faults.size();
    scene::NumberPairs const table = scene::read_number_pairs(
        c, "file", folder, {scene::ColumnQuantity::length, scene::ColumnQuantity::length}, "x,y in mm", faults);
    if (faults.size() > before)
        return {};
    std::vector<Vec2> points;
    for (scene::NumberPair const& row : table.rows)
        if (!add_point(points, {row.value[0], row.value[1]}, c, "file",
                       "line " + std::to_string(row.line) + " of " + table.file, faults))
            return {};
    if (points.size() < spline_order) {
        faults.push_back(scene::parameter_fault(
            c, "file", table.file + " holds " + std::to_string(points.size()) + " points, a spline needs 4",
            "write at least 4 points"));
        return {};
    }
    return points;
}

/// Cubic B-splines on given knots.
class SplineBasis
{
  public:
    /// Value and slope.
    static constexpr std::size_t derivatives = 2;

    explicit SplineBasis(std::vector<double> const& knots)
        : work_(gsl_bspline_alloc(spline_order, knots.size())), values_(gsl_matrix_calloc(spline_order, derivatives))
    {
        std::unique_ptr<gsl_vector, Free<gsl_vector_free>> const at_knots(gsl_vector_alloc(knots.size()));
        if (!work_ || !at_knots || !values_)
            throw std::bad_alloc();
        for (std::size_t i = 0; i < knots.size(); ++i)
            gsl_vector_set(at_knots.get(), i, knots[i]);
        check(gsl_bspline_knots(at_knots.get(), work_.get()));
    }

    /// Calls @p visit(number, value, slope) for each spline that is not zero at @p s; the slope has no meaning where
    /// @p derivative is 0.
    template <class Visit>
    void at(double s, std::size_t derivative, Visit&& visit)
    {
        std::size_t first = 0;
        check(non_zero(s, derivative, values_.get(), &first, work_.get()));
        for (std::size_t k = first; k < first + spline_order; ++k)
            visit(k, gsl_matrix_get(values_.get(), k - first, 0), gsl_matrix_get(values_.get(), k - first, 1));
    }

    static void check(int status)
    {
        if (status != GSL_SUCCESS)
            throw NumericalError(ErrorCode::no_solution, "profile", "spline through points", gsl_strerror(status));
    }

  private:
    /// The spline_order splines that are not zero at @p s; GSL 2.8 gave the function another name.
    static int non_zero(double s, std::size_t derivative, gsl_matrix* values, std::size_t* first,
                        gsl_bspline_workspace* work)
    {
#if GSL_MAJOR_VERSION > 2 || GSL_MINOR_VERSION >= 8
        return gsl_bspline_basis_deriv(s, derivative, values, first, work);
#else
        std::size_t last = 0;
        return gsl_bspline_deriv_eval_nonzero(s, derivative, values, first, &last, work);
#endif
    }

    std::unique_ptr<gsl_bspline_workspace, Free<gsl_bspline_free>> work_;
    std::unique_ptr<gsl_matrix, Free<gsl_matrix_free>> values_;
};

/// Coefficients of the spline that is @p points at the parameters @p s.
Eigen::MatrixX2d interpolated(SplineBasis& basis, std::vector<double> const& s, std::vector<Vec2> const& points)
{
    constexpr std::size_t band = spline_order - 1;  // on either side: spline i is not zero at point i
    std::unique_ptr<gsl_matrix, Free<gsl_matrix_free>> const matrix(gsl_matrix_calloc(s.size(), 3 * band + 1));
    std::unique_ptr<gsl_vector_uint, Free<gsl_vector_uint_free>> const rows(gsl_vector_uint_alloc(s.size()));
    if (!matrix || !rows)
        throw std::bad_alloc();
    for (std::size_t i = 0; i < s.size(); ++i)
        basis.at(s[i], 0, [&](std::size_t k, double value, double) {
            gsl_matrix_set(matrix.get(), k, 2 * band + i - k,
                           value);  // as GSL keeps a band, with room for exchanged rows
        });
    SplineBasis::check(gsl_linalg_LU_band_decomp(s.size(), band, band, matrix.get(), rows.get()));
    Eigen::MatrixX2d solution(static_cast<Eigen::Index>(s.size()), 2);
    for (std::size_t i = 0; i < points.size(); ++i)
        solution.row(static_cast<Eigen::Index>(i)) = points[i].transpose();
    for (Eigen::Index k = 0; k < 2; ++k) {
        auto column = gsl_vector_view_array(solution.col(k).data(), s.size());
        SplineBasis::check(gsl_linalg_LU_band_svx(band, band, matrix.get(), rows.get(), &column.vector));
    }
    if (!solution.allFinite())
        throw NumericalError(ErrorCode::no_solution, "profile", "spline through points",
                             "the interpolation is singular");
    return solution;
}

}  // namespace

std::vector<CurvePiece> spline_through(std::vector<Vec2> const& points)
{
    gsl_set_error_handler_off();
    std::vector<double> s(points.size(), 0.0);
    for (std::size_t i = 1; i < points.size(); ++i)
        s[i] = s[i - 1] + (points[i] - points[i - 1]).norm();
    // not-a-knot: the second and the last but one point are no knots
    std::vector<double> knots{s.front()};
    knots.insert(knots.end(), s.begin() + 2, s.end() - 2);
    knots.push_back(s.back());
    SplineBasis basis(knots);
    Eigen::MatrixX2d const coefficients = interpolated(basis, s, points);

    auto const value_and_slope = [&](double at) {
        Eigen::Matrix2d result = Eigen::Matrix2d::Zero();
        basis.at(at, 1, [&](std::size_t k, double value, double slope) {
            result.row(0) += value * coefficients.row(static_cast<Eigen::Index>(k));
            result.row(1) += slope * coefficients.row(static_cast<Eigen::Index>(k));
        });
        return result;
    };
    std::vector<CurvePiece> pieces;
    Eigen::Matrix2d left = value_and_slope(knots[0]);
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
        Eigen::Matrix2d const right_end = value_and_slope(knots[i + 1]);
        double const third = (knots[i + 1] - knots[i]) / 3;
        auto const axis = [&](Eigen::Index k) {
            return std::vector<double>{left(0, k), left(0, k) + third * left(1, k),
                                       right_end(0, k) - third * right_end(1, k), right_end(0, k)};
        };
        pieces.emplace_back(axis(0), axis(1));
        left = right_end;
    }
    return pieces;
}

namespace {

/// The tooth of the spline through @p points, either way round; `side` of @p choice says what they are. Faults name @p
/// key.
Profile tooth_through(std::vector<Vec2> points, scene::FamilyChoice const& c, std::string_view key,
                      ToothPlace const& place, Faults& faults)
{
    scene::ParameterFaults const refuse(c, faults);
    bool const full = c.word("side").value_or("right") == "full";
    // the flank runs from tip to root, the whole tooth from left to right
    if (full ? points.front().x() > points.back().x() : points.front().y() < points.back().y())
        std::reverse(points.begin(), points.end());
    auto const [low, high] = std::ranges::minmax_element(points, {}, [](Vec2 const& p) { return p.y(); });
    double const h_a = high->y(), h_f = -low->y();
    if (!(h_a > 0) || !(h_f > 0))
        refuse(key,
               "the points span y = " + short_number(-h_f) + " ... " + short_number(h_a) +
                   " and do not cross the pitch line y = 0",
               "measure y from the pitch line, up towards the tip");
    auto const [leftmost, rightmost] = std::ranges::minmax_element(points, {}, [](Vec2 const& p) { return p.x(); });
    bool const mirrored = !(rightmost->x() > 0);
    std::string const mirror_it = "mirror it: change the sign of each x";
    Vec2 const& left = points.front();
    Vec2 const& right = points.back();
    if (full && !(left.x() < 0 && right.x() > 0 && left.y() < 0 && right.y() < 0))
        refuse(key,
               "a whole tooth begins left of its centre line below the pitch line and ends right of it; this one runs "
               "from " +
                   short_point(left) + " to " + short_point(right),
               mirrored            ? mirror_it + ", and set side = \"right\""
               : leftmost->x() < 0 ? "give both flanks in order, from the left root over the tip to the right root"
                                   : "give the left flank too, or set side = \"right\"");
    if (!full && points.front().x() < 0)
        refuse(key, "the tip of the right flank is left of the tooth's centre line x = 0",
               mirrored ? "this is a left flank: " + mirror_it
                        : "give the right flank with x >= 0, or, of a whole tooth, set side = \"full\"");
    if (refuse.any())
        return {};
    FlankSegment const segment = curve_segment(full ? "tooth" : "flank", spline_through(points));
    double top = h_a;
    if (full)
        top = validate_whole_tooth(segment, h_a, -h_f, c, key, faults);
    else
        validate_flank({segment}, c, key, faults);
    if (refuse.any())
        return {};
    return full ? whole_tooth({segment}, place, top, h_f, false) : symmetric_tooth({segment}, place, h_a, h_f);
}

/// Cubic spline with continuous curvature and not-a-knot ends through the points of a CSV file, parameter = chord
/// length.
///
/// The file has two columns x,y in mm, y from the pitch line, '#' starts a comment, one header line is allowed.
/// side = "right" (default): the right flank between tip and root, mirrored; "full": the whole tooth from left root to
/// right root. Accuracy: passes through every point to roundoff; between points O(h^4) for data from a smooth curve.
/// Domain: 4 to 10 000 points, no two neighbours equal. The addendum and dedendum are the largest and smallest y; the
/// addendum of a whole tooth is the height of its curve.
Profile points_tooth(scene::FamilyChoice const& c, ToothPlace const& place, Faults& faults)
{
    std::vector<Vec2> points = read_points(c, place.folder, faults);
    return points.empty() ? Profile{} : tooth_through(std::move(points), c, "file", place, faults);
}

/// The spline of family "points" (cubic, continuous curvature, not-a-knot ends, parameter = chord length) through
/// points of the scene.
///
/// side = "right" (default): the right flank between tip and root, mirrored; "full": the whole tooth from left root to
/// right root. Addendum and dedendum are those of "points". Accuracy: passes through every point to roundoff. Refused:
/// neighbours on each other, curves that cross themselves, flanks that cross the centre line.
Profile b_spline_tooth(scene::FamilyChoice const& c, ToothPlace const& place, Faults& faults)
{
    std::vector<Vec2> points;
    for (std::vector<double> const& row : c.rows("points"))
        if (!add_point(points, {row[0], row[1]}, c, "points", "row " + std::to_string(points.size() + 1), faults))
            return {};
    return tooth_through(std::move(points), c, "points", place, faults);
}

}  // namespace

Family measured_points()
{
    using enum scene::Quantity;
    return {{"points",
             "a smooth spline through measured or computed points",
             {{"file", file, "CSV file with columns x,y in mm, y from the pitch line"},
              scene::with_words({"side", word, "what the file holds; default \"right\"", false}, {"right", "full"})}},
            points_tooth};
}

Family b_spline()
{
    using enum scene::Quantity;
    return {{"b-spline",
             "a smooth spline through points given in the scene",
             {scene::with_words({"points", rows, "points of the tooth, y from the pitch line", true, 4}, {"[x, y]"}),
              scene::with_words({"side", word, "what the points are; default \"right\"", false}, {"right", "full"})}},
            b_spline_tooth};
}

}  // namespace hdconj::profile
