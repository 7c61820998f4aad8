// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Points of the solver's branches against 50 digits: angle by quadrature of the arc length, contact
/// by bisection on n.v with difference quotients of the transform itself.
#include <iostream>
#include <sstream>

#include "support/catch.hpp"
#include "support/oracle/envelope.hpp"
#include "support/oracle/run.hpp"

namespace hdconj::test::fifty_digits_cases {

using namespace oracle;
using hdconj::BranchRecord;
using hdconj::Kinematics;
using hdconj::Scene;
using hdconj::Solution;

namespace {

struct Errors
{
    double phi = 0, point = 0;
    std::size_t samples = 0, corners = 0, lost = 0;
    std::string where;
};

class Judge
{
  public:
    explicit Judge(Scene const& scene) : tooth_(scene), motion_(scene), rule_(30) {}

    /// Distance of sample @p i of @p branch from the true envelope point at the same position.
    void look_at(BranchRecord const& branch, std::size_t i, Errors& errors) const
    {
        ++errors.samples;
        // The solver's position, taken as exact; everything else is computed again.
        Fifty const s(motion_.exact ? branch.u[i] : branch.phi[i]);
        Fifty const phi = motion_.phi_by_quadrature(s, rule_, 2);
        Fifty const other = motion_.exact ? abs(phi - Fifty(branch.phi[i])) : abs(motion_.u(s) - Fifty(branch.u[i]));
        errors.phi = std::max(errors.phi, static_cast<double>(other));
        auto const pose = motion_.pose(s, phi);
        auto const segment = static_cast<std::size_t>(branch.segment);
        Point<Fifty> on;
        if (branch.kind == "corner") {
            ++errors.corners;
            on = tooth_.on_whole(segment, Fifty(1)).point;
        } else {
            auto const rate = motion_.pose_rate(s);
            auto const f = [&](Fifty const& t) {
                auto const profile = tooth_.on_whole(segment, t);
                Point<Fifty> const v = rate.origin + profile.point.x * rate.along + profile.point.y * rate.outward;
                return dot(profile.normal.x * pose.along + profile.normal.y * pose.outward, v);
            };
            Fifty const t(branch.t[i]);
            Fifty a, b, fa, fb;
            double width = 1e-10;
            for (; width < 1e-2; width *= 10) {
                a = t - width;
                b = t + width;
                fa = f(a);
                fb = f(b);
                if ((fa < 0) != (fb < 0))
                    break;
            }
            if (width >= 1e-2) {
                ++errors.lost;
                errors.where = place(branch, i);
                return;
            }
            on = tooth_.on_whole(segment, bracketed(f, a, fa, b, fb, Fifty("1e-30"))).point;
        }
        Point<Fifty> const found{Fifty(branch.point[i].x()), Fifty(branch.point[i].y())};
        double const error = static_cast<double>(length(found - pose.to_circular_spline(on)));
        if (!(error <= errors.point)) {
            errors.point = error;
            errors.where = place(branch, i);
        }
    }

  private:
    static std::string place(BranchRecord const& branch, std::size_t i)
    {
        std::ostringstream text;
        text << branch.kind << " " << branch.segment_name << " at u = " << branch.u[i] << ", t = " << branch.t[i];
        return text.str();
    }

    Tooth<Fifty> tooth_;
    Motion<Fifty> motion_;
    GaussLegendre<Fifty> rule_;
};

Errors judged(Solution const& solution, std::size_t samples)
{
    Judge const judge(solution.scene);
    std::size_t all = 0;
    for (auto const& branch : solution.branches)
        all += branch.u.size();
    std::size_t const stride = std::max<std::size_t>(1, all / samples);
    Errors errors;
    std::size_t counter = 0;
    for (auto const& branch : solution.branches)
        for (std::size_t i = 0; i < branch.u.size(); ++i)
            // the ends of each branch always, the rest evenly
            if (i == 0 || i + 1 == branch.u.size() || counter++ % stride == 0)
                judge.look_at(branch, i, errors);
    return errors;
}

}  // namespace

TEST_CASE("50 digits: points of every branch of type-50", "[reference]")
{
    for (Kinematics const kinematics : hdconj::all_kinematics) {
        Solution solution = hdconj::solve(type_50(kinematics));
        Tooth<double> const tooth(solution.scene);
        REQUIRE(solution.segment_names.size() == tooth.pieces_of_whole());
        for (auto const& branch : solution.branches) {
            REQUIRE(branch.u.size() == branch.point.size());
            REQUIRE(branch.u.size() == branch.phi.size());
            REQUIRE(branch.u.size() == branch.t.size());
        }
        Errors const errors = judged(solution, 1000);
        std::cout << "50 digits, " << hdconj::to_string(kinematics) << ": " << errors.samples << " samples, "
                  << errors.corners << " of corners; angle " << errors.phi << " rad, point " << errors.point << " mm ("
                  << errors.where << ")\n";
        INFO(errors.where);
        CHECK(errors.samples >= 300);
        CHECK(errors.corners > 0);
        CHECK(errors.lost == 0);
        CHECK(errors.phi <= 1e-15);
        CHECK(errors.point <= 1e-12);

        // Negative control: a point 3e-12 mm off, an angle 1e-14 rad off.
        auto& branch = solution.branches.front();
        branch.point.front().x() += 3e-12;
        branch.phi.front() += kinematics == Kinematics::exact ? 1e-14 : 0;
        branch.u.front() += kinematics == Kinematics::exact ? 0 : 1e-14;
        Errors spoiled;
        Judge(solution.scene).look_at(branch, 0, spoiled);
        CHECK(spoiled.point > 1e-12);
        CHECK(spoiled.phi > 1e-15);
    }
}

TEST_CASE("50 digits: r_0 and derived dimensions of type-50", "[reference]")
{
    Scene const scene = type_50();
    Solution const solution = hdconj::solve(scene);
    Motion<Fifty> const motion(scene);
    Tooth<Fifty> const tooth(scene);
    CHECK(static_cast<double>(abs(motion.r_0 - Fifty(solution.geometry.r_0))) < 1e-14);
    CHECK(static_cast<double>(abs(motion.r_m - Fifty(solution.geometry.r_m))) < 1e-14);
    CHECK(static_cast<double>(abs(tooth.pitch_line - Fifty(solution.geometry.pitch_line))) < 1e-15);
    CHECK(solution.geometry.r_0 - solution.geometry.r_m == Approx(-2.567e-3).epsilon(0).margin(5e-7));
    CHECK(solution.geometry.ratio == -100.0);
}

}  // namespace hdconj::test::fifty_digits_cases
