// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <sstream>

#include "hdconj/result_files.hpp"
#include "support/catch.hpp"
#include "support/sample_solution.hpp"
#include "support/temporary_folder.hpp"

namespace hdconj::test::dxf_cases {

namespace {

struct Polyline
{
    bool closed = false;
    std::vector<Vec2> points;
    std::vector<double> z;
};

/// Polylines by layer; reads group by group, as R12 asks.
std::map<std::string, std::vector<Polyline>> read(std::string const& text)
{
    std::map<std::string, std::vector<Polyline>> found;
    std::istringstream lines(text);
    std::string code, value, type, layer;
    while (std::getline(lines, code) && std::getline(lines, value)) {
        auto& polylines = found[layer];
        if (code == "0") {
            type = value;
        } else if (code == "8") {
            layer = value;
            if (type == "POLYLINE") {
                found[layer].emplace_back();
            } else if (type == "VERTEX") {
                found[layer].back().points.emplace_back();
            }
        } else if (code == "70" && type == "POLYLINE") {
            polylines.back().closed = value == "1";
        } else if (type == "VERTEX" && code == "10") {
            polylines.back().points.back().x() = std::stod(value);
        } else if (type == "VERTEX" && code == "20") {
            polylines.back().points.back().y() = std::stod(value);
        } else if (type == "VERTEX" && code == "30") {
            polylines.back().z.push_back(std::stod(value));
        }
    }
    found.erase("");
    return found;
}

std::string dxf_of(Solution const& solution)
{
    test::TemporaryFolder const folder;
    write_dxf(solution, folder / "a.dxf");
    return test::content(folder / "a.dxf");
}

void check_equal(std::vector<Vec2> const& found, std::vector<Vec2> const& wanted, Vec2 const& shift = Vec2::Zero())
{
    constexpr double rounding = 1e-10;  // [mm], promised
    REQUIRE(found.size() == wanted.size());
    for (std::size_t i = 0; i < found.size(); ++i)
        REQUIRE((found[i] - wanted[i] - shift).cwiseAbs().maxCoeff() <= rounding);
}

}  // namespace

TEST_CASE("DXF holds the three outlines on their layers")
{
    auto const solution = sample::solution();
    auto layers = read(dxf_of(solution));
    REQUIRE(layers.size() == 3);
    auto const& spline = layers["CIRCULAR_SPLINE"].at(0);
    CHECK_FALSE(spline.closed);
    check_equal(spline.points, solution.circular_spline.outline[0]);
    auto const& tooth = layers["FLEXSPLINE_TOOTH"].at(0);
    CHECK_FALSE(tooth.closed);
    auto const& geometry = solution.geometry;
    check_equal(tooth.points, solution.flexspline_outline, Vec2(0, geometry.r_0 + geometry.w0 + geometry.pitch_line));
    CHECK(layers["NEUTRAL_CURVE"].at(0).closed);
    check_equal(layers["NEUTRAL_CURVE"].at(0).points, solution.neutral_curve);
}

TEST_CASE("each slice is a polyline at its z")
{
    auto solution = sample::solution();
    solution.circular_spline.z = {-3.5, 3.5};
    solution.circular_spline.outline.assign(2, solution.circular_spline.outline.front());
    auto const slices = read(dxf_of(solution))["CIRCULAR_SPLINE"];
    REQUIRE(slices.size() == 2);
    CHECK(slices[0].z.front() == -3.5);
    CHECK(slices[1].z.back() == 3.5);
}

TEST_CASE("DXF numbers have no exponent, no negative zero, and ten decimals at any size")
{
    Solution solution;
    solution.neutral_curve = {{1e-20, -1e-20}, {1e-10, -1.23456789012e-5}, {12345678.1234567890, -0.5}};
    auto const text = dxf_of(solution);
    CHECK(text.find("e-") == std::string::npos);
    CHECK(text.find("-0.0\n") == std::string::npos);
    CHECK(text.find("\n0.0000000001\n") != std::string::npos);
    CHECK(text.find("\n-0.0000123457\n") != std::string::npos);
    check_equal(read(text)["NEUTRAL_CURVE"].at(0).points, solution.neutral_curve);
}

}  // namespace hdconj::test::dxf_cases
