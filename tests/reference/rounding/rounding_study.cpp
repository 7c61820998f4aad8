// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Where the digits go: writes data/reference/rounding-*.csv, which docs/explanation/stability.md explains.
#include <cstdio>
#include <fstream>
#include <iostream>

#include "support/catch.hpp"
#include "support/random_designs.hpp"
#include "support/rounding/cases.hpp"
#include "support/rounding/special.hpp"

namespace hdconj::test::rounding_study {

using namespace rounding;

namespace {

constexpr double deg_per_rad = 57.29577951308232;
constexpr std::uint64_t random_seed = 20250301;

std::string printed(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    return text;
}

/// Decimal digits lost by an error of so many roundoffs.
std::string digits(double roundoffs)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.1f", std::max(0.0, std::log10(std::max(roundoffs, 1e-3))));
    return text;
}

/// Worst of all contacts of a drive, for each step.
struct Worst
{
    Contact at;  ///< where the condition is worst
    Losses condition{}, in_float{}, in_double{}, in_long_double{}, in_program{};
};

void take(std::array<Worst, judged_count>& worst, Contact const& c)
{
    for (std::size_t i = 0; i < judged_count; ++i) {
        if (c.condition[i] > worst[i].condition[i])
            worst[i].at = c;
        for (auto member :
             {&Worst::condition, &Worst::in_float, &Worst::in_double, &Worst::in_long_double, &Worst::in_program})
            (worst[i].*member)[i] =
                std::max((worst[i].*member)[i], member == &Worst::condition        ? c.condition[i]
                                                : member == &Worst::in_float       ? c.in_float[i]
                                                : member == &Worst::in_double      ? c.in_double[i]
                                                : member == &Worst::in_long_double ? c.in_long_double[i]
                                                                                   : c.in_program[i]);
    }
}

void write_cases(std::string const& folder)
{
    std::ofstream out(folder + "/rounding-cases.csv");
    out << "# digits lost, worst of all contacts of the right flank; written by "
           "tests/reference/rounding/rounding_study.cpp\n"
           "case,step,condition,float,double,long_double,program,worst_piece,worst_u_deg\n";
    for (auto const& [name, scene] : cases()) {
        FourTypes const drive(scene);
        std::array<Worst, judged_count> worst;
        auto const all = places(drive.in_double(), 24);
        for (Place const& place : all)
            take(worst, drive(place));
        std::cerr << name << ": " << all.size() << " contacts\n";
        for (std::size_t i = 0; i < judged_count; ++i) {
            Worst const& w = worst[i];
            out << name << ',' << judged_names[i] << ',' << printed(w.condition[i]) << ',' << digits(w.in_float[i])
                << ',' << digits(w.in_double[i]) << ',' << digits(w.in_long_double[i]) << ','
                << (w.in_program[i] > 0 ? digits(w.in_program[i]) : "-") << ',' << w.at.piece << ','
                << printed(w.at.place.u * deg_per_rad) << '\n';
        }
    }
}

/// Quantiles of the worst condition of each of many random designs, and the worst design by name.
void write_random(std::string const& folder, int designs)
{
    std::ofstream out(folder + "/rounding-random.csv");
    out << "# worst condition of each step in " << designs << " random designs (tests/support/random_designs.hpp, seed "
        << random_seed
        << "), exact motion, and digits lost there; written by tests/reference/rounding/rounding_study.cpp\n"
           "step,median,ninety_nine_percent,worst,double_digits,program_digits,design,module,z_f,z_c,waves,family,"
           "piece,u_deg\n";
    struct Found
    {
        Contact contact;
        Losses worst_double{}, worst_program{};
        int design = 0;
        Scene scene;
    };
    std::array<std::vector<double>, judged_count> worst;
    std::array<Found, judged_count> record;
    designs::RandomDesigns random(random_seed);
    for (int design = 0; design < designs; ++design) {
        FourTypes const drive(random.next());
        std::array<Worst, judged_count> mine;
        for (Place const& place : places(drive.in_double(), 6))
            take(mine, drive(place));
        for (std::size_t i = 0; i < judged_count; ++i) {
            worst[i].push_back(mine[i].condition[i]);
            if (mine[i].condition[i] > record[i].contact.condition[i])
                record[i] = {mine[i].at, mine[i].in_double, mine[i].in_program, design, drive.scene()};
        }
        if (design % 100 == 99)
            std::cerr << design + 1 << " designs\n";
    }
    for (std::size_t i = 0; i < judged_count; ++i) {
        std::sort(worst[i].begin(), worst[i].end());
        auto const quantile = [&](double share) {
            return worst[i][static_cast<std::size_t>(share * static_cast<double>(worst[i].size() - 1))];
        };
        Found const& f = record[i];
        out << judged_names[i] << ',' << printed(quantile(0.5)) << ',' << printed(quantile(0.99)) << ','
            << printed(quantile(1)) << ',' << digits(f.contact.in_double[i]) << ','
            << (f.contact.in_program[i] > 0 ? digits(f.contact.in_program[i]) : "-") << ',' << f.design << ','
            << printed(f.scene.drive.module) << ',' << f.scene.drive.flexspline_teeth << ','
            << f.scene.drive.circular_spline_teeth << ',' << f.scene.wave_generator.waves << ','
            << f.scene.flexspline.profile.family << ',' << f.contact.piece << ','
            << printed(f.contact.place.u * deg_per_rad) << '\n';
    }
}

/// Error of the position found for a profile point that is touched twice, @p apart before the fold, and how far the
/// point found is from the envelope (over the tooth's height).
template <class T>
void write_fold_row(std::ofstream& out, FourTypes const& drive, std::size_t piece, int sign, Fifty const& fold,
                    Fifty const& apart)
{
    Fifty const u = fold + apart;
    Inputs<Fifty> exact = drive.in_fifty().inputs(piece, 0.5, 0, sign);
    exact.u = u;
    exact.phi = drive.in_fifty().motion.phi(u);
    Steps<Fifty> const right = steps(exact);

    Inputs<T> in = drive.template drive<T>().inputs(piece, 0.5, 0, sign);
    in.x = oracle::as<T>(right.contact);
    in.n = oracle::as<T>(right.normal);
    auto const f = [&](T const& at) {
        in.u = at;
        return steps(in).condition;
    };
    T const start(fold), far(fold + 3 * apart + 30 * sqrt(Fifty(std::numeric_limits<T>::epsilon())));
    // where rounding has swallowed the pair, the fold itself is the answer
    T const found = root(f, start, far).value_or(start);
    Fifty const wrong = abs(Fifty(found) - u);
    Inputs<Fifty> at_found = exact;
    at_found.u = Fifty(found);
    at_found.phi = drive.in_fifty().motion.phi(at_found.u);
    auto const pose = drive.in_fifty().motion.pose(at_found.u);
    Point<Fifty> const shift = pose.to_circular_spline(right.contact) - right.point;
    out << ',' << printed(static_cast<double>(wrong)) << ','
        << printed(static_cast<double>(abs(dot(shift, right.across)) / drive.height()));
}

void write_fold(std::string const& folder)
{
    FourTypes const drive(oracle::type_50());
    std::size_t const convex = 1;
    int const sign = place_at(drive.in_double(), convex, 0.5, 0.1).sign;
    Fifty const fold =
        special_position(drive, convex, sign, 0.03, [](auto const& s, auto const& in) { return turning(s, in); });
    std::ofstream out(folder + "/rounding-fold.csv");
    out << "# type-50, convex arc: the contact turns back at u = " << fold.str(12)
        << "; a profile point touches `apart` after it.\n"
           "# error of the position found from n.v = 0 [rad], and of the envelope point across the envelope (tooth "
           "heights)\n"
           "apart,float,float_across,double,double_across,long_double,long_double_across\n";
    for (int k = 0; k <= 42; ++k) {
        Fifty const apart = pow(Fifty(10), -Fifty(k) / 4 - Fifty(1) / 2);
        out << printed(static_cast<double>(apart));
        write_fold_row<float>(out, drive, convex, sign, fold, apart);
        write_fold_row<double>(out, drive, convex, sign, fold, apart);
        write_fold_row<long double>(out, drive, convex, sign, fold, apart);
        out << '\n';
    }
}

/// Relative errors of one type at the position of that type next to @p u; nothing when the type has none there.
template <class T>
void write_at(std::ofstream& out, FourTypes const& drive, std::size_t piece, int sign, Fifty const& u,
              Fifty const& from, Judged first, Judged second)
{
    T const rounded(u);
    Fifty const apart = abs(Fifty(rounded) - from), wanted = abs(u - from);
    if (!(apart > wanted / 2 && apart < wanted * 2)) {
        out << ",,";
        return;
    }
    auto const at = [&](auto const& typed, auto const& position) {
        auto in = typed.inputs(piece, 0.5, 0, sign);
        in.u = position;
        in.phi = typed.motion.phi(in.u);
        return in;
    };
    Inputs<Fifty> const exact = at(drive.in_fifty(), Fifty(rounded));
    Losses const wrong = errors(steps(at(drive.template drive<T>(), rounded)), steps(exact), exact, drive.height());
    out << ',' << printed(wrong[first]) << ',' << printed(wrong[second]);
}

void write_all_types(std::ofstream& out, FourTypes const& drive, std::size_t piece, int sign, Fifty const& u,
                     Fifty const& from, Judged first, Judged second)
{
    write_at<float>(out, drive, piece, sign, u, from, first, second);
    write_at<double>(out, drive, piece, sign, u, from, first, second);
    write_at<long double>(out, drive, piece, sign, u, from, first, second);
    out << '\n';
}

void write_cusp(std::string const& folder)
{
    FourTypes const drive(swallowtail());
    std::size_t const concave = 0;
    int const sign = place_at(drive.in_double(), concave, 0.5, 0.1).sign;
    Fifty const cusp =
        special_position(drive, concave, sign, 0.003, [](auto const& s, auto const&) { return s.speed; });
    std::ofstream out(folder + "/rounding-cusp.csv");
    out << "# swallowtail design, concave arc: cusp of the envelope at u = " << cusp.str(12)
        << "; `apart` after it.\n"
           "# relative error of the envelope's speed, and error of the point across the envelope (tooth heights)\n"
           "apart,float,float_across,double,double_across,long_double,long_double_across\n";
    for (int k = 0; k <= 48; ++k) {
        Fifty const apart = pow(Fifty(10), -Fifty(k) / 4 - 1);
        out << printed(static_cast<double>(apart));
        write_all_types(out, drive, concave, sign, cusp + apart, cusp, judged_speed, judged_across);
    }
}

void write_fast(std::string const& folder)
{
    FourTypes const drive(fast_contact());
    std::size_t const line = 0;
    std::vector<double> inside;
    double const half = drive.in_double().motion.half_lobe();
    // from the first to the last position at which the flank is touched before the major axis
    for (int k = 0; k < 100000; ++k) {
        double const u = -half * k / 100000 / 2;
        Inputs<double> const in = drive.in_double().inputs(line, 0.5, u, 1);
        double const place = steps(in).place;
        if (place >= 0 && place <= length(in.b - in.a))
            inside.push_back(u);
    }
    std::ofstream out(folder + "/rounding-fast.csv");
    out << "# fast contact design, straight flank: errors of the point along and across the envelope (tooth heights) "
           "while the contact runs\n"
           "# over the flank; `place` = height on the flank, 0 root, 1 tip\n"
           "u_deg,place,float,float_across,double,double_across,long_double,long_double_across\n";
    if (inside.empty())
        throw std::runtime_error("rounding study: the flank is never touched");
    constexpr int rows = 80;
    double const first = inside.back(), last = inside.front();
    for (int k = 0; k < rows; ++k) {
        double const u = static_cast<double>(static_cast<float>(first + (last - first) * (k + 0.5) / rows));
        Inputs<double> const in = drive.in_double().inputs(line, 0.5, u, 1);
        double const place = steps(in).place / length(in.b - in.a);
        if (place < 0 || place > 1)
            continue;
        char angle[32];
        std::snprintf(angle, sizeof angle, "%.4f", u * deg_per_rad);
        out << angle << ',' << printed(place);
        write_all_types(out, drive, line, 1, Fifty(u), Fifty(0), judged_along, judged_across);
    }
}

}  // namespace

TEST_CASE("writes the tables of rounding", "[.][rounding-tables]")
{
    std::string const folder = HDCONJ_SOURCE_DIR "/data/reference";
    write_cases(folder);
    write_fold(folder);
    write_cusp(folder);
    write_fast(folder);
    write_random(folder, 1000);
}

}  // namespace hdconj::test::rounding_study
