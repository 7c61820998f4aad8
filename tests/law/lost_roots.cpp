// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// No root lost, none invented: close pairs of contacts planted on random curves, in t at one instant, judged in 50
/// digits.
#include <array>
#include <boost/multiprecision/mpfr.hpp>
#include <cmath>
#include <cstdio>
#include <limits>
#include <span>
#include <vector>

#include "hdconj/envelope/contact.hpp"
#include "hdconj/envelope/double_roots.hpp"
#include "support/catch.hpp"
#include "support/draws.hpp"
#include "support/oracle/touch_law.hpp"
#include "support/type50.hpp"

namespace hdconj::test::lost_roots_cases {

/// 50 decimal digits, by MPFR: hundreds of millions of operations are needed.
using Fifty =
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<50, boost::multiprecision::allocate_stack>,
                                  boost::multiprecision::et_off>;

namespace {

template <class T>
using Coefficients = std::vector<T>;

template <class T>
T value_at(Coefficients<T> c, T const& t)
{
    for (std::size_t r = c.size() - 1; r > 0; --r)
        for (std::size_t i = 0; i < r; ++i)
            c[i] += t * (c[i + 1] - c[i]);
    return c[0];
}

double binomial(std::size_t n, std::size_t k)
{
    double value = 1;
    for (std::size_t i = 0; i < k; ++i)
        value = value * static_cast<double>(n - i) / static_cast<double>(i + 1);
    return std::round(value);
}

/// The three functions of the meshing condition of the curve with exactly the coordinates given, built without the
/// library:
/// -(x.x'), -y' and x' as Bernstein forms of one degree.
template <class T>
struct Functions
{
    Coefficients<T> a, b, c;

    explicit Functions(profile::CurvePiece const& curve)
    {
        Coefficients<T> const x = lift(curve.x()), y = lift(curve.y());
        Coefficients<T> const one(x.size(), T(1));
        Coefficients<T> const xx = product(x, slope(x)), yy = product(y, slope(y));
        for (std::size_t i = 0; i < xx.size(); ++i)
            a.push_back(-xx[i] - yy[i]);
        b = product(one, slope(y));
        for (T& value : b)
            value = -value;
        c = product(one, slope(x));
    }

    [[nodiscard]] Coefficients<T> combined(PlanarVelocity const& w) const
    {
        Coefficients<T> f;
        for (std::size_t i = 0; i < a.size(); ++i)
            f.push_back(T(w.omega) * a[i] + T(w.q.x()) * b[i] + T(w.q.y()) * c[i]);
        return f;
    }

  private:
    static Coefficients<T> lift(std::vector<double> const& v) { return Coefficients<T>(v.begin(), v.end()); }
    static Coefficients<T> slope(Coefficients<T> const& v)
    {
        Coefficients<T> d;
        for (std::size_t i = 0; i + 1 < v.size(); ++i)
            d.push_back(T(static_cast<double>(v.size() - 1)) * (v[i + 1] - v[i]));
        return d;
    }
    static Coefficients<T> product(Coefficients<T> const& p, Coefficients<T> const& q)
    {
        std::size_t const m = p.size() - 1, n = q.size() - 1;
        Coefficients<T> r(m + n + 1, T(0));
        for (std::size_t i = 0; i <= m; ++i)
            for (std::size_t j = 0; j <= n; ++j)
                r[i + j] += T(binomial(m, i) * binomial(n, j)) * p[i] * q[j];
        for (std::size_t k = 0; k < r.size(); ++k)
            r[k] /= T(binomial(m + n, k));
        return r;
    }
};

/// The reference: every root by sign changes of the Bernstein coefficients in 50 digits.
class Reference
{
  public:
    struct Isolated
    {
        double lo, hi;  ///< exactly representable: halves of halves
        int left;       ///< sign at lo
    };

    explicit Reference(Coefficients<Fifty> f) : f_(std::move(f)) { isolate(f_, 0, 1, 0); }

    [[nodiscard]] std::vector<Isolated> const& roots() const { return roots_; }
    [[nodiscard]] int sign(double t) const
    {
        Fifty const v = value_at(f_, Fifty(t));
        return v > 0 ? 1 : v < 0 ? -1 : 0;
    }
    /// Whether the root lies in [low, high].
    [[nodiscard]] bool inside(Isolated root, double low, double high) const
    {
        if (root.hi < low || root.lo > high)
            return false;
        if (root.lo < low && sign(low) != root.left)
            return false;
        return root.hi <= high || sign(high) != root.left;
    }

  private:
    void isolate(Coefficients<Fifty> c, double a, double b, int depth)
    {
        int changes = 0;
        int before = 0;
        for (Fifty const& v : c) {
            int const s = v > 0 ? 1 : v < 0 ? -1 : 0;
            changes += s != 0 && before != 0 && s != before;
            before = s != 0 ? s : before;
        }
        // a root on a cut has a zero coefficient on both sides; the left piece keeps it
        bool const at_end = c.back() == 0;
        bool const at_start = c.front() == 0 && a == 0;
        if (changes == 0 && !at_end && !at_start)
            return;
        constexpr int deepest = 52;
        if ((changes == 1 && !at_end && !at_start && c.front() != 0) || depth == deepest) {
            roots_.push_back({a, b, c.front() > 0 ? 1 : -1});
            return;
        }
        Coefficients<Fifty> high(c.size());
        std::size_t const n = c.size() - 1;
        high[n] = c[n];
        for (std::size_t r = 1; r <= n; ++r) {
            for (std::size_t i = n; i >= r; --i)
                c[i] = ldexp(c[i - 1] + c[i], -1);
            high[n - r] = c[n];
        }
        double const middle = 0.5 * (a + b);
        isolate(std::move(c), a, middle, depth + 1);
        isolate(std::move(high), middle, b, depth + 1);
    }

    Coefficients<Fifty> f_;
    std::vector<Isolated> roots_;
};

struct Row
{
    int cases = 0;
    int two = 0;         ///< the planted pair came out as two simple roots
    int flagged = 0;     ///< ... as a near-double root
    int none = 0;        ///< rounding of the input left no real pair, and none was reported
    int lost = 0;        ///< roots of the reference that are neither listed nor inside a near-double root
    int invented = 0;    ///< simple roots listed that the reference does not have
    int naive_lost = 0;  ///< roots that a scan of 400 steps does not see
    double widest = 0;
};

constexpr int first_decade = 2;
constexpr int last_decade = 12;
using Table = std::array<Row, last_decade + 1>;

/// Ends of the curve count as inside and outside.
constexpr double at_end = 0x1p-40;

void judge(profile::CurvePiece const& curve, PlanarVelocity const& twist, double t1, double t2, Row& row)
{
    ++row.cases;
    numeric::BernsteinRoots const found = envelope::curve_contacts(curve, twist);
    REQUIRE(found.complete);
    Reference const reference(Functions<Fifty>(curve).combined(twist));
    auto const number = [](int i) { return static_cast<std::size_t>(i); };

    // what the reference has outside of near-double roots
    std::vector<bool> covered(reference.roots().size(), false);
    std::size_t in_doubles = 0;
    bool planted_flagged = false;
    for (int i = 0; i < found.count; ++i) {
        double const half = found.width[number(i)] / 2;
        if (half == 0)
            continue;
        double const low = found.t[number(i)] - half, high = found.t[number(i)] + half;
        planted_flagged = planted_flagged || (low <= t1 && t2 <= high);
        row.widest = std::max(row.widest, 2 * half);
        for (std::size_t k = 0; k < covered.size(); ++k)
            if (!covered[k] && reference.inside(reference.roots()[k], low, high)) {
                covered[k] = true;
                ++in_doubles;
            }
    }
    // each simple root listed has a change of sign about it, in intervals that are disjoint
    int confirmed = 0, near_planted = 0;
    for (int i = 0; i < found.count; ++i) {
        if (found.width[number(i)] > 0)
            continue;
        double const t = found.t[number(i)];
        if (t < at_end || t > 1 - at_end)
            continue;
        double room = 0x1p-20;
        for (int j : {i - 1, i + 1})
            if (j >= 0 && j < found.count)
                room = std::min(room, (std::abs(found.t[number(j)] - t) - found.width[number(j)] / 2) / 3);
        room = std::min({room, t, 1 - t});
        if (room > 0 && reference.sign(t - room) * reference.sign(t + room) < 0)
            ++confirmed;
        else
            ++row.invented;
        near_planted += std::abs(t - t1) <= 0.4 * (t2 - t1) || std::abs(t - t2) <= 0.4 * (t2 - t1);
    }
    int outside = 0;
    for (std::size_t k = 0; k < covered.size(); ++k)
        outside += !covered[k] && !reference.inside(reference.roots()[k], 0, at_end) &&
                   !reference.inside(reference.roots()[k], 1 - at_end, 1);
    row.lost += std::max(0, outside - confirmed);
    row.invented += std::max(0, confirmed - outside);
    row.flagged += planted_flagged;
    row.two += !planted_flagged && near_planted >= 2;
    row.none += !planted_flagged && near_planted < 2;

    // the control: signs on a grid
    numeric::BernsteinWork f{};
    std::size_t const size = curve.a().size();
    (void)envelope::meshing_polynomial(curve, twist, {f.data(), size});
    constexpr int steps = 400;
    int seen = 0;
    bool before = numeric::bernstein_value({f.data(), size}, 0) < 0;
    for (int i = 1; i <= steps; ++i) {
        bool const now = numeric::bernstein_value({f.data(), size}, static_cast<double>(i) / steps) < 0;
        seen += now != before;
        before = now;
    }
    row.naive_lost += std::max(0, static_cast<int>(reference.roots().size()) - seen);
}

void report(char const* title, Table const& table)
{
    std::printf("%s\n  %-8s%9s%9s%9s%9s%9s%9s%12s%12s\n", title, "distance", "cases", "two", "flagged", "none", "lost",
                "invented", "widest", "scan lost");
    for (int d = first_decade; d <= last_decade; ++d) {
        Row const& r = table[static_cast<std::size_t>(d)];
        std::printf("  1e-%-5d%9d%9d%9d%9d%9d%9d%12.1e%12d\n", d, r.cases, r.two, r.flagged, r.none, r.lost, r.invented,
                    r.widest, r.naive_lost);
    }
    std::fflush(stdout);
}

Row total(Table const& table)
{
    Row sum;
    for (Row const& r : table) {
        sum.cases += r.cases;
        sum.two += r.two;
        sum.flagged += r.flagged;
        sum.lost += r.lost;
        sum.invented += r.invented;
        sum.naive_lost += r.naive_lost;
    }
    return sum;
}

/// A curve that runs on without turning back, of the size of a tooth.
profile::CurvePiece random_curve(designs::Draws& random, int degree)
{
    double const size = std::pow(10, random.between(-3, 0));
    double const heading = random.between(-3.1, 3.1);
    Vec2 const start{random.between(-0.5, 0.5), random.between(0.3, 1.2)};
    std::vector<double> x, y;
    for (int i = 0; i <= degree; ++i) {
        double const s = size * (i + random.between(-0.4, 0.4)) / degree;
        double const d = size * random.between(-0.3, 0.3);
        x.push_back(start.x() + s * std::cos(heading) - d * std::sin(heading));
        y.push_back(start.y() + s * std::sin(heading) + d * std::cos(heading));
    }
    return profile::CurvePiece(x, y);
}

}  // namespace

TEST_CASE("lost roots: pairs planted by the choice of the velocity on random curves", "[lost]")
{
    // two linear conditions on (theta', q_x, q_y): f(t1) = 0 and (f(t2) - f(t1))/(t2 - t1) = 0
    designs::Draws random(1);
    Table table{};
    int const wanted = oracle::full_run() ? 66'000 : 22'000;
    for (int k = 0; k < wanted; ++k) {
        int const decade = first_decade + k % (last_decade - first_decade + 1);
        profile::CurvePiece const curve = random_curve(random, random.whole(2, 7));
        double const distance = std::pow(10.0, -decade);
        double const t1 = random.between(0.01, 0.98), t2 = t1 + distance;
        Functions<Fifty> const f(curve);
        auto const at = [&](Coefficients<Fifty> const& c) {
            Fifty const first = value_at(c, Fifty(t1));
            return std::array<Fifty, 2>{first, (value_at(c, Fifty(t2)) - first) / (Fifty(t2) - Fifty(t1))};
        };
        auto const a = at(f.a), b = at(f.b), c = at(f.c);
        PlanarVelocity twist{
            static_cast<double>(b[0] * c[1] - c[0] * b[1]),
            {static_cast<double>(c[0] * a[1] - a[0] * c[1]), static_cast<double>(a[0] * b[1] - b[0] * a[1])}};
        double const size = std::abs(twist.omega) + twist.q.norm();
        if (!(size > 0))
            continue;
        twist = {twist.omega / size, twist.q / size};
        judge(curve, twist, t1, t2, table[static_cast<std::size_t>(decade)]);
    }
    report("pairs planted by the velocity (below 1e-8 its rounding decides whether the pair is real)", table);
    Row const sum = total(table);
    CHECK(sum.cases >= wanted / 66 * 65);
    CHECK(sum.lost == 0);
    CHECK(sum.invented == 0);
    CHECK(sum.naive_lost > sum.cases / 2);
    CHECK(table[4].two > 0.99 * table[4].cases);
    CHECK(table[9].two == 0);
}

TEST_CASE("lost roots: pairs that are real in the doubles given, down to 1e-12", "[lost]")
{
    // translation along (q_x, q_y): f = q_y x' - q_x y'. With x = p t and y' = k (t - m)^2 all coordinates are short
    // binary fractions and f = q_y p - q_x k (t - m)^2 has the roots m +- D/2 for q_y = q_x k D^2/(4 p), a power of
    // two.
    designs::Draws random(2);
    Table table{};
    for (int n = 0; n < 22000; ++n) {
        int const decade = first_decade + n % (last_decade - first_decade + 1);
        int const exponent = static_cast<int>(std::lround(decade * std::log2(10.0)));
        double const distance = std::ldexp(1.0, -exponent);
        double const m = std::ldexp(random.whole(8, 504), -9);
        double const k = random.sign() * std::ldexp(random.whole(1, 15), -3);
        double const p = std::ldexp(1.0, random.whole(-2, 1));
        // integral of k (t - m)^2: cubic with the Bernstein coefficients y_0, then steps of a third of those of the
        // slope
        std::array<double, 3> const slope{k * m * m, -k * m * (1 - m), k * (1 - m) * (1 - m)};
        double const y0 = std::ldexp(random.whole(100, 900), -10);
        // tripled, so that the thirds are whole: the curve is three times as large
        std::vector<double> const y{3 * y0, 3 * y0 + slope[0], 3 * y0 + slope[0] + slope[1],
                                    3 * y0 + slope[0] + slope[1] + slope[2]};
        std::vector<double> const x{0, p, 2 * p, 3 * p};
        double const q_x = std::ldexp(random.sign(), random.whole(-2, 2));
        double const q_y = q_x * k * distance * distance / (4 * p);
        judge(profile::CurvePiece(x, y), {0, {q_x, q_y}}, m - distance / 2, m + distance / 2,
              table[static_cast<std::size_t>(decade)]);
    }
    report("pairs real in the doubles given", table);
    Row const sum = total(table);
    CHECK(sum.cases == 22000);
    CHECK(sum.lost == 0);
    CHECK(sum.invented == 0);
    CHECK(sum.two + sum.flagged == sum.cases);
    CHECK(table[last_decade].flagged == table[last_decade].cases);
    CHECK(sum.naive_lost > sum.cases);
}

TEST_CASE("lost roots: contacts of real drives next to the instant at which they merge", "[lost]")
{
    designs::Draws random(3);
    Table table{};
    int drives = 0;
    while (total(table).cases < 22000) {
        int const waves = random.whole(1, 3);
        double const r_m = random.between(10, 60);
        int const z_f = random.whole(60, 320);
        double const ratio = static_cast<double>(z_f) / (z_f + waves);
        Exact const motion(wavegen::NeutralCurve<wavegen::CosineCam>(
                               wavegen::CosineCam{r_m / z_f * random.between(0.7, 1.15), waves}, r_m),
                           ratio);
        double const end = motion.half_lobe();
        motion::RatesModel const rates = motion::rates_model(motion, -end, end);
        REQUIRE(rates.resolved);
        ++drives;
        for (int c = 0; c < 60; ++c) {
            profile::CurvePiece const curve = random_curve(random, random.whole(2, 7));
            for (envelope::DoubleRoot const& root : envelope::DoubleRootSearch(curve, rates, -end, end)().roots) {
                if (!root.separated)
                    continue;
                // D^2 = -8 f_u du / f_tt
                motion::MotionRates const at = motion.rates(root.u);
                auto const f = [&](PlanarVelocity const& w, double t) {
                    Functions<double> const g(curve);
                    return value_at(g.combined(w), t);
                };
                double const h = 0x1p-12;
                double const f_tt =
                    (f(at.twist, root.t + h) - 2 * f(at.twist, root.t) + f(at.twist, root.t - h)) / (h * h);
                double const f_u = f(at.change, root.t);
                for (int decade = first_decade; decade <= last_decade; ++decade) {
                    double const distance = std::pow(10.0, -decade);
                    double const du = -f_tt * distance * distance / (8 * f_u);
                    if (!(std::abs(du) < 0.01))
                        continue;
                    judge(curve, motion.rates(root.u + du).twist, root.t - distance / 2, root.t + distance / 2,
                          table[static_cast<std::size_t>(decade)]);
                }
            }
        }
    }
    report("contacts of random drives next to the instant at which they merge", table);
    Row const sum = total(table);
    CHECK(drives > 20);
    CHECK(sum.lost == 0);
    CHECK(sum.invented == 0);
    CHECK(sum.naive_lost > sum.cases / 2);
}

}  // namespace hdconj::test::lost_roots_cases
