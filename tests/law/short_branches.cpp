// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// No branch lost for being short: contacts that cross the end of a profile piece twice within 1e-2 ... 1e-12 of u,
/// judged in 50 digits.
#include <array>
#include <boost/multiprecision/mpfr.hpp>
#include <cmath>
#include <cstdio>
#include <utility>

#include "hdconj/envelope/find_branches.hpp"
#include "support/catch.hpp"
#include "support/draws.hpp"
#include "support/oracle/touch_law.hpp"
#include "support/type50.hpp"

namespace hdconj::test::short_branches_cases {

namespace {

using FiftyDigits =
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<50, boost::multiprecision::allocate_stack>,
                                  boost::multiprecision::et_off>;

/// Exact motion of a cosine cam with the doubles given, in any number type.
template <class T>
struct Velocity
{
    double w0, r_0, r_m, k;
    int n;

    /// theta', q_x, q_y
    [[nodiscard]] std::array<T, 3> operator()(T const& u) const
    {
        using std::cos;
        using std::sin;
        using std::sqrt;
        T const waves(n);
        T const c = cos(waves * u), s = sin(waves * u);
        T const rho = T(r_0) + T(w0) * c, rho1 = -waves * T(w0) * s, rho2 = -waves * waves * T(w0) * c;
        T const length2 = rho * rho + rho1 * rho1;
        T const length = sqrt(length2);
        T const per = T(k) / T(r_m);
        return {T(1) - per * length - (rho * rho2 - rho1 * rho1) / length2, length - per * rho * rho, per * rho * rho1};
    }

    /// n.v of a point
    [[nodiscard]] T normal_speed(Vec2 const& x, Vec2 const& normal, T const& u) const
    {
        auto const [omega, q_x, q_y] = (*this)(u);
        return T(normal.x()) * (omega * T(x.y()) + q_x) + T(normal.y()) * (q_y - omega * T(x.x()));
    }
};

using Rates = std::array<FiftyDigits, 3>;

/// A point that moves in the same direction at u1 and at u2, on a random line through the tooth.
/// @param first, change  the rates at u1 and their divided difference to u2
bool point_of_equal_direction(Rates const& first, Rates const& change, designs::Draws& random, Vec2& x, Vec2& along)
{
    double const angle = random.between(0, 6.28);
    Vec2 const start{random.between(-0.5, 0.5), random.between(0.3, 1.2)};
    Vec2 const step{std::cos(angle), std::sin(angle)};
    // velocity and change along the line are a + s b
    auto const part = [&](Rates const& w, FiftyDigits s) {
        FiftyDigits const px = start.x() + s * step.x(), py = start.y() + s * step.y();
        return std::pair<FiftyDigits, FiftyDigits>(w[0] * py + w[1], w[2] - w[0] * px);
    };
    auto const turning = [&](FiftyDigits s) {
        auto const [vx, vy] = part(first, s);
        auto const [cx, cy] = part(change, s);
        return vx * cy - vy * cx;
    };
    FiftyDigits const t0 = turning(0), t1 = turning(1), t2 = turning(-1);
    FiftyDigits const a = (t1 + t2) / 2 - t0, b = (t1 - t2) / 2;
    FiftyDigits const square = b * b - 4 * a * t0;
    if (!(square > 0))
        return false;
    FiftyDigits const s = -2 * t0 / (b + (b < 0 ? -1 : 1) * sqrt(square));
    if (!(abs(s) < 0.6))
        return false;
    x = start + static_cast<double>(s) * step;
    auto const [vx, vy] = part(first, s);
    along = Vec2(static_cast<double>(vx), static_cast<double>(vy));
    if (!(along.norm() > 0.02))
        return false;
    along.normalize();
    return true;
}

struct DecadeRow
{
    int cases = 0, two = 0, flagged = 0, none = 0, lost = 0, invented = 0, naive_lost = 0, without_branch = 0;
    double widest = 0, reach = 0;
};

/// The two roots next to @p u, in 50 digits, or none.
struct Pair
{
    bool real = false;
    double low = 0, high = 0;
};

Pair reference_pair(Velocity<FiftyDigits> const& velocity, profile::PieceEnd const& end, double u)
{
    auto const g = [&](FiftyDigits const& at) { return velocity.normal_speed(end.point, end.normal, at); };
    FiftyDigits const h("1e-15");
    FiftyDigits extreme(u);
    FiftyDigits curvature = 0;
    for (int k = 0; k < 6; ++k) {
        FiftyDigits const a = g(extreme - h), b = g(extreme), c = g(extreme + h);
        curvature = (a - 2 * b + c) / (h * h);
        extreme -= (c - a) / (2 * h) / curvature;
    }
    FiftyDigits const value = g(extreme);
    FiftyDigits const square = -2 * value / curvature;
    if (!(square > 0))
        return {};
    FiftyDigits const half = sqrt(square);
    Pair pair;
    pair.real = true;
    for (int side : {-1, 1}) {
        FiftyDigits a = extreme + side * half, b = extreme + side * half * FiftyDigits("1.001");
        FiftyDigits ga = g(a), gb = g(b);
        for (int k = 0; k < 8 && ga != gb; ++k) {
            FiftyDigits const next = b - gb * (b - a) / (gb - ga);
            a = b;
            ga = gb;
            b = next;
            gb = g(b);
        }
        (side < 0 ? pair.low : pair.high) = static_cast<double>(b);
    }
    return pair;
}

}  // namespace

TEST_CASE("short branches: a contact that crosses an end twice is found or flagged with a width", "[lost]")
{
    designs::Draws random(5);
    constexpr int first_decade = 2;
    constexpr int last_decade = 12;
    std::array<DecadeRow, last_decade + 1> table{};
    int const wanted = oracle::full_run() ? 6600 : 2200;
    int tried = 0;
    for (int k = 0; k < wanted; ++tried) {
        int const n = 1 + tried % 3;
        double const r_m = random.between(10, 60);
        double const teeth = std::floor(random.between(60, 320));
        double const ratio = teeth / (teeth + n);
        Exact const motion(wavegen::NeutralCurve<wavegen::CosineCam>(
                               wavegen::CosineCam{r_m / teeth * random.between(0.7, 1.15), n}, r_m),
                           ratio);
        wavegen::CosineCam const& cam = motion.curve().shape();
        double const r_0 = motion.curve().r_0();
        double const lobe = motion.half_lobe();
        motion::RatesModel const rates = motion::rates_model(motion, -lobe, lobe);
        for (int decade = first_decade; decade <= last_decade; ++decade) {
            double const distance = std::pow(10.0, -decade);
            double const u1 = random.between(-0.9 * lobe, 0.9 * lobe);
            Velocity<FiftyDigits> const velocity{cam.w0, r_0, r_m, ratio, n};
            Rates const first = velocity(FiftyDigits(u1));
            Rates change = velocity(FiftyDigits(u1) + distance);
            for (std::size_t i = 0; i < change.size(); ++i)
                change[i] = (change[i] - first[i]) / distance;
            Vec2 x, along;
            bool planted = false;
            for (int attempt = 0; attempt < 50 && !planted; ++attempt)
                planted = point_of_equal_direction(first, change, random, x, along);
            if (!planted)
                continue;
            ++k;
            DecadeRow& row = table[static_cast<std::size_t>(decade)];
            ++row.cases;
            // the end of a line whose normal is perpendicular to the velocity there
            profile::LinePiece const line{x - random.between(0.05, 0.4) * along, x};
            profile::PieceShape const shape = line;
            profile::PieceEnd const end = profile::end_of(shape);
            std::vector<envelope::CriticalAngle> events;
            envelope::TraceRecord record;
            envelope::end_crossings(shape, 0, motion, rates, -lobe, lobe, events, record);

            Pair const pair = reference_pair(velocity, end, u1 + distance / 2);
            // each root of the reference is listed, or lies in a doubt
            double const near_by = pair.real ? 0.4 * (pair.high - pair.low) / 2 : 0x1p-20;
            auto const doubted = [&](double u) {
                bool any = false;
                for (envelope::RootDoubt const& doubt : record.doubts)
                    if (doubt.t == 1 && std::abs(u - doubt.u) <= doubt.width / 2 + near_by) {
                        any = true;
                        row.widest = std::max(row.widest, doubt.width);
                        row.reach = std::max(row.reach, doubt.reach);
                    }
                return any;
            };
            int close = 0, alone = 0;
            std::array<double, 2> at{};
            bool low_found = false, high_found = false;
            for (envelope::CriticalAngle const& e : events) {
                if (e.t != 1 || doubted(e.u))
                    continue;
                bool const low = std::abs(e.u - pair.low) <= near_by, high = std::abs(e.u - pair.high) <= near_by;
                alone += !pair.real && std::abs(e.u - u1) <= near_by;
                if (!pair.real || !(low || high))
                    continue;
                low_found = low_found || low;
                high_found = high_found || high;
                at[static_cast<std::size_t>(std::min(close++, 1))] = e.u;
            }
            bool const flagged = pair.real ? doubted(pair.low) || doubted(pair.high) : doubted(u1);
            row.flagged += flagged;
            row.two += !flagged && close == 2;
            row.none += !flagged && !pair.real;
            if (pair.real)
                row.lost += !(low_found || doubted(pair.low)) + !(high_found || doubted(pair.high));
            row.invented += pair.real ? std::max(0, close - 2) : alone;
            if (!flagged && close == 2) {
                // the branch of that length is there
                profile::Profile profile;
                profile.segment_names = {"only"};
                profile.pieces.push_back({shape, 0, 0, 1, false});
                bool begins = false, ends = false;
                for (envelope::Branch const& branch :
                     envelope::find_branches(envelope::Envelope<Exact>(profile, motion, 0), 1).branches)
                    for (envelope::ContactArc const& arc : branch.arcs)
                        for (double const u : {arc.u_begin, arc.u_end}) {
                            begins = begins || u == at[0];
                            ends = ends || u == at[1];
                        }
                row.without_branch += !begins || !ends;
            }
            // the control: signs on a grid of 2000 steps, next to the pair
            if (pair.real) {
                Velocity<double> const v{cam.w0, r_0, r_m, ratio, n};
                double const step = 2 * lobe / 2000;
                double const from = -lobe + step * std::floor((pair.low + lobe) / step);
                int seen = 0;
                for (double u = from; u < pair.high; u += step)
                    seen += (v.normal_speed(end.point, end.normal, u) < 0) !=
                            (v.normal_speed(end.point, end.normal, u + step) < 0);
                row.naive_lost += std::max(0, 2 - seen);
            }
        }
    }
    std::printf("contacts that cross an end twice\n  %-8s%9s%9s%9s%9s%9s%9s%12s%12s%12s\n", "distance", "cases", "two",
                "flagged", "none", "lost", "invented", "widest", "reach [mm]", "scan lost");
    DecadeRow sum;
    for (int d = first_decade; d <= last_decade; ++d) {
        DecadeRow const& r = table[static_cast<std::size_t>(d)];
        std::printf("  1e-%-5d%9d%9d%9d%9d%9d%9d%12.1e%12.1e%12d\n", d, r.cases, r.two, r.flagged, r.none, r.lost,
                    r.invented, r.widest, r.reach, r.naive_lost);
        sum.cases += r.cases;
        sum.lost += r.lost;
        sum.invented += r.invented;
        sum.naive_lost += r.naive_lost;
        sum.without_branch += r.without_branch;
        sum.reach = std::max(sum.reach, r.reach);
    }
    std::fflush(stdout);
    CHECK(sum.cases >= wanted);
    CHECK(sum.lost == 0);
    CHECK(sum.invented == 0);
    CHECK(sum.without_branch == 0);
    CHECK(table[4].two > 0.95 * table[4].cases);
    CHECK(sum.naive_lost > sum.cases / 2);
    // what a flagged pair could hide is below the rounding of the points themselves
    CHECK(sum.reach < 1e-14);
}

}  // namespace hdconj::test::short_branches_cases
