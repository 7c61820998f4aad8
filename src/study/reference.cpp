// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>

#include "fifty.hpp"
#include "given_contact.hpp"
#include "hdconj/numeric/parallel.hpp"
#include "study_drive.hpp"

namespace hdconj::detail {
namespace {

using Point = Pair<Fifty>;

/// Contact arcs in 50 digits.
class FiftyDrive
{
  public:
    explicit FiftyDrive(StudyDrive const& drive) : drive_(drive), motion_(drive.numbers()), envelope_(drive.envelope()) {}

    [[nodiscard]] GivenContact<Fifty> contact(BoundaryPiece const& piece, Fifty const& u) const
    {
        ContactArc const& arc = drive_.arc(piece);
        if (arc.resting)
            throw NumericalError("reference", "profile piece " + std::to_string(arc.piece), "an arc's centre is at rest, which has no reference in 50 digits");
        Place<Fifty> const place = motion_.at(u);
        Fifty const offset(drive_.offset);
        GivenContact<Fifty> found = std::visit(
            [&](auto const& shape) {
                if constexpr (std::is_same_v<std::decay_t<decltype(shape)>, CurvePiece>)
                    return contact_at(shape, envelope_.contact(arc, static_cast<double>(u)).t, place, offset);
                else
                    return contact_at(shape, arc.candidate, place, offset);
            },
            drive_.tooth.pieces[static_cast<std::size_t>(arc.piece)].shape);
        if (piece.copy != 0)
        {
            Fifty const angle = Fifty(piece.copy) * motion_.pitch();
            Fifty const c = cos(angle), s = sin(angle);
            auto const turn = [&](Point const& a) -> Point { return {a.x * c + a.y * s, a.y * c - a.x * s}; };
            found.point = turn(found.point);
            found.normal = turn(found.normal);
        }
        return found;
    }
    [[nodiscard]] Point point(BoundaryPiece const& piece, Fifty const& u) const { return contact(piece, u).point; }
    [[nodiscard]] Fifty half_pitch() const { return motion_.pitch() / 2; }

  private:
    StudyDrive const& drive_;
    GivenMotion<Fifty> motion_;
    Envelope<StudyMotion> envelope_;
};

/// Fits Chebyshev series to a curve in 50 digits, cutting it in halves until they follow it.
class Fitter
{
  public:
    explicit Fitter(double size) : target_(size * 0x1p-56) {}

    std::vector<ReferencePatch> patches;
    double error = 0;

    void add(std::function<Point(Fifty const&)> const& curve, int stretch) { fit(curve, Fifty(0), Fifty(1), stretch, 0); }

  private:
    static constexpr int nodes = 20;

    void fit(std::function<Point(Fifty const&)> const& curve, Fifty const& from, Fifty const& to, int stretch, int depth)
    {
        std::array<Point, nodes> value;
        std::array<Fifty, nodes> angle;
        Fifty const half = (to - from) / 2, middle = (from + to) / 2;
        for (int i = 0; i < nodes; ++i)
        {
            auto const k = static_cast<std::size_t>(i);
            angle[k] = half_turn<Fifty>() * (Fifty(i) + Fifty(0.5)) / nodes;
            value[k] = curve(middle + half * cosine(i));
        }
        ReferencePatch patch;
        patch.stretch = stretch;
        for (int j = 0; j < nodes; ++j)
        {
            Fifty x(0), y(0);
            for (int i = 0; i < nodes; ++i)
            {
                Fifty const& c = cosine_of_multiple(j * (2 * i + 1));
                x += value[static_cast<std::size_t>(i)].x * c;
                y += value[static_cast<std::size_t>(i)].y * c;
            }
            Fifty const factor = Fifty(j == 0 ? 1 : 2) / nodes;
            patch.x.push_back(static_cast<long double>(factor * x));
            patch.y.push_back(static_cast<long double>(factor * y));
        }
        double missed = 0;
        for (double const s : {-0.93, -0.41, 0.37, 0.88})
        {
            Point const truth = curve(middle + half * Fifty(s));
            Fifty const dx = truth.x - Fifty(value_of(patch.x, s)), dy = truth.y - Fifty(value_of(patch.y, s));
            missed = std::max(missed, static_cast<double>(sqrt(dx * dx + dy * dy)));
        }
        constexpr int deepest = 16;
        if (missed > target_ && depth < deepest)
        {
            fit(curve, from, middle, stretch, depth + 1);
            fit(curve, middle, to, stretch, depth + 1);
            return;
        }
        error = std::max(error, missed);
        patches.push_back(std::move(patch));
    }

    static long double value_of(std::vector<long double> const& c, double s)
    {
        long double b1 = 0, b2 = 0;
        for (std::size_t k = c.size(); k-- > 1;)
        {
            long double const b = 2 * static_cast<long double>(s) * b1 - b2 + c[k];
            b2 = b1;
            b1 = b;
        }
        return static_cast<long double>(s) * b1 - b2 + c[0];
    }

    /// cos(m pi / (2 nodes))
    static Fifty const& cosine_of_multiple(int m)
    {
        static std::vector<Fifty> const table = [] {
            std::vector<Fifty> all;
            for (int k = 0; k < 4 * nodes; ++k)
                all.push_back(cos(half_turn<Fifty>() * k / (2 * nodes)));
            return all;
        }();
        return table[static_cast<std::size_t>(m % (4 * nodes))];
    }
    static Fifty const& cosine(int i) { return cosine_of_multiple(2 * i + 1); }

    double target_;
};

/// A stretch of boundary with ends in 50 digits.
struct Stretch
{
    BoundaryPiece piece;
    Fifty begin, end;   ///< u; on a land the angle
};

/// u along a stretch, 0 ... 1, quadratic at an end where two contacts merge: there the contact moves at finite speed.
Fifty along(StudyDrive const& drive, Stretch const& stretch, Fifty const& s)
{
    ContactArc const& arc = drive.arc(stretch.piece);
    auto const folds = [&](double u) {
        return (u == arc.u_begin && arc.begins == BranchEnd::double_root) || (u == arc.u_end && arc.ends == BranchEnd::double_root);
    };
    bool const first = folds(stretch.piece.begin), last = folds(stretch.piece.end);
    Fifty share = s;
    if (first && last)
        share = s * s * (3 - 2 * s);
    else if (first)
        share = s * s;
    else if (last)
        share = s * (2 - s);
    return stretch.begin + share * (stretch.end - stretch.begin);
}

[[noreturn]] void lost(std::string const& what, Stretch const& at)
{
    throw NumericalError("reference", "profile piece " + std::to_string(at.piece.arc) + " at u = " + std::to_string(static_cast<double>(at.begin)),
                         what + " did not converge in 50 digits");
}

constexpr int budget = 30;

/// Newton's method with difference quotients on |p(u)| = radius.
void meet_circle(FiftyDrive const& drive, Stretch const& at, Fifty& u, Fifty const& radius)
{
    Fifty const h("1e-22"), enough("1e-32");
    for (int i = 0; i < budget; ++i)
    {
        Fifty const f = length(drive.point(at.piece, u)) - radius;
        Fifty const slope = (length(drive.point(at.piece, u + h)) - radius - f) / h;
        Fifty const step = f / slope;
        u -= step;
        if (abs(step) < enough)
            return;
    }
    lost("the crossing of the tip circle", at);
}

/// The same on p_a(u) = p_b(u'); stretches that join in one tangent keep their ends: an error along both is none across.
void meet(FiftyDrive const& drive, Stretch& a, Stretch& b)
{
    Fifty const h("1e-22"), enough("1e-32");
    GivenContact<Fifty> const at_a = drive.contact(a.piece, a.end), at_b = drive.contact(b.piece, b.begin);
    Fifty const crossing = abs(at_a.normal.x * at_b.normal.y - at_a.normal.y * at_b.normal.x);
    Fifty const smooth(0x1p-20);
    if (crossing < smooth)
        return;
    // a corner of the tooth takes over from its flank: the same instant, and the path of the corner need not cross the flank's
    if (a.piece.copy == b.piece.copy && a.end == b.begin && a.piece.arc != b.piece.arc)
        return;
    for (int i = 0; i < budget; ++i)
    {
        Point const p = drive.point(a.piece, a.end), q = drive.point(b.piece, b.begin);
        Point const dp = (1 / h) * (drive.point(a.piece, a.end + h) - p), dq = (1 / h) * (drive.point(b.piece, b.begin + h) - q);
        Point const gap = p - q;
        Fifty const determinant = -dp.x * dq.y + dp.y * dq.x;
        Fifty const ua = (-gap.x * dq.y + gap.y * dq.x) / determinant;
        Fifty const ub = (dp.x * gap.y - dp.y * gap.x) / determinant;
        a.end -= ua;
        b.begin -= ub;
        if (abs(ua) < enough && abs(ub) < enough)
            return;
    }
    lost("a corner of the boundary", a);
}

void add_stretch(Fitter& fitter, StudyDrive const& drive, FiftyDrive const& fifty, Stretch const& stretch, int number)
{
    if (stretch.piece.arc < 0)
    {
        Fifty const radius(drive.geometry.circular_spline_inner_radius);
        fitter.add(
            [&](Fifty const& s) -> Point {
                Fifty const angle = stretch.begin + s * (stretch.end - stretch.begin);
                return {radius * sin(angle), radius * cos(angle)};
            },
            number);
        return;
    }
    fitter.add([&](Fifty const& s) { return fifty.point(stretch.piece, along(drive, stretch, s)); }, number);
}

}  // namespace

ReferenceCurve reference_of(StudyDrive const& drive)
{
    FiftyDrive const fifty(drive);
    std::vector<Stretch> stretches;
    for (BoundaryPiece const& piece : drive.pieces)
        stretches.push_back({piece, Fifty(piece.begin), Fifty(piece.end)});
    Fifty const radius(drive.geometry.circular_spline_inner_radius);
    for (std::size_t i = 0; i + 1 < stretches.size(); ++i)
    {
        Stretch& a = stretches[i];
        Stretch& b = stretches[i + 1];
        if (a.piece.arc < 0)
        {
            meet_circle(fifty, b, b.begin, radius);
            Point const p = fifty.point(b.piece, b.begin);
            a.end = atan2(p.x, p.y);
        }
        else if (b.piece.arc < 0)
        {
            meet_circle(fifty, a, a.end, radius);
            Point const p = fifty.point(a.piece, a.end);
            b.begin = atan2(p.x, p.y);
        }
        else
        {
            meet(fifty, a, b);
        }
    }
    stretches.front().begin = -fifty.half_pitch();
    stretches.back().end = fifty.half_pitch();
    double const size = drive.geometry.circular_spline_inner_radius;
    Fitter fitter(size);
    for (std::size_t i = 0; i < stretches.size(); ++i)
        add_stretch(fitter, drive, fifty, stretches[i], static_cast<int>(i));
    return {std::move(fitter.patches), fitter.error};
}

ReferenceCurve reference_of(StudyDrive const& drive, BoundaryPiece const& piece)
{
    FiftyDrive const fifty(drive);
    Fitter fitter(drive.geometry.circular_spline_inner_radius);
    add_stretch(fitter, drive, fifty, {piece, Fifty(piece.begin), Fifty(piece.end)}, 0);
    return {std::move(fitter.patches), fitter.error};
}

}  // namespace hdconj::detail
