// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The second problem: what the cam between the major axis and the first contact does to the curve beyond.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "cam/start.hpp"
#include "given_flanks.hpp"
#include "hdconj/solve.hpp"
#include "hdconj/units.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

namespace hdconj::test::second_problem_cases {

using given_flanks::KnownCurve;
using given_flanks::rounding_of;

namespace {

/// type-50's teeth with another wave generator.
Scene type_50_with(std::string const& family, std::vector<std::pair<std::string, double>> const& values)
{
    Scene scene = oracle::type_50();
    scene::FamilyChoice shape;
    shape.family = family;
    shape.path = scene.wave_generator.shape.path;
    shape.given["radial_deformation"] = scene.wave_generator.shape.given.at("radial_deformation");
    for (auto const& [key, value] : values)
        shape.given[key] = {value, 0};
    scene.wave_generator.shape = shape;
    return scene;
}

/// The same with a table of rows that are @p step degrees apart, the first of them @p first steps from the axis.
Scene type_50_with_rows(double step, double first, std::filesystem::path const& folder)
{
    Scene scene = oracle::type_50();
    double const w0 = std::get<double>(scene.wave_generator.shape.given.at("radial_deformation").value);
    std::ofstream out(folder / "cam.csv");
    out.precision(17);
    out << "angle_deg,w_mm\n";
    for (int i = 0; i * step < 180; ++i) {
        double const angle = (i + first) * step, x = 2 * angle * deg;
        out << angle << "," << w0 * (std::cos(x) + 0.05 * std::cos(2 * x)) << "\n";
    }
    out.close();
    scene::FamilyChoice shape;
    shape.family = "table";
    shape.path = scene.wave_generator.shape.path;
    shape.given["file"] = {"cam.csv", 0};
    scene.folder = folder;
    scene.wave_generator.shape = shape;
    return scene;
}

/// The curve from the axis on against the known one, and the error that its beginning states.
struct BeginError
{
    double most = 0;   ///< of the true error over the stated one
    double error = 0;  ///< largest that is stated [mm]
};

BeginError begin_error(Scene const& scene)
{
    Solution const solution = solve(scene);
    KnownCurve const known(solution.scene, solution.geometry.r_m);
    auto const given = given_flanks::flanks_of(solution, known.motion);
    REQUIRE(given);
    double const rounding = rounding_of(solution.scene);
    cam::MeshBegin const begin =
        cam::mesh_begin(given->pair, given->rule, 2, known.state(0)[0], std::numbers::pi / 4, rounding);
    REQUIRE(begin.point.x > 0);
    CHECK(std::abs(begin.first - given->begin) <= begin.first_error + 1e-9);
    std::vector<double> angles;
    for (double x = begin.point.x; x < std::min(given->end, 40 * deg); x += deg)
        angles.push_back(x);
    double const share = 1e-11 / std::max(1e-11, std::abs(begin.shift[0]));
    cam::MarchedCurve const curve = cam::march(given->pair, given->rule, begin.point, angles, rounding);
    cam::MarchedCurve const other = cam::march(given->pair, given->rule, begin.shifted(share).point, angles, rounding);
    REQUIRE(std::min(curve.points.size(), other.points.size()) == angles.size());
    BeginError found;
    constexpr double others = 1e-10;  // mm, of flanks and march
    double stated = 0;
    for (std::size_t i = 0; i < angles.size(); ++i) {
        double const w = curve.points[i].state[0];
        stated = std::max(stated, std::abs(other.points[i].state[0] - w) / share);
        found.most = std::max(found.most, std::abs(w - known.state(angles[i])[0]) / (stated + others));
    }
    found.error = stated;
    std::cout << "second problem, " << scene.wave_generator.shape.family << ": begins at " << to_deg(begin.first)
              << " deg, errs by " << found.most << " of " << found.error << " mm\n";
    return found;
}

}  // namespace

TEST_CASE("second problem: the error of the beginning holds for a cam that breaks near the axis", "[second-problem]")
{
    TemporaryFolder const folder;
    double largest = 0;
    for (double const first : {0.0, 0.5})
        for (double const step : {15.0, 10.0, 6.0, 5.0, 3.0, 2.0}) {
            INFO("rows " << step << " deg apart from " << first * step << " deg on");
            BeginError const found = begin_error(type_50_with_rows(step, first, folder.path()));
            CHECK(found.most <= 1);
            largest = std::max(largest, found.error);
        }
    CHECK(largest > 1e-8);
}

TEST_CASE("second problem: the beginning of a smooth cam is known to rounding", "[second-problem]")
{
    for (Scene const& scene :
         {oracle::type_50(), type_50_with("ellipse", {}), type_50_with("four-roller", {{"roller_angle_deg", 30}}),
          type_50_with("two-disc", {{"wrap_angle_deg", 25}})}) {
        INFO(scene.wave_generator.shape.family);
        BeginError const found = begin_error(scene);
        CHECK(found.most <= 1);
        CHECK(found.error < 1e-9);
    }
}

}  // namespace hdconj::test::second_problem_cases
