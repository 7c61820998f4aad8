// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The law of the S-tooth: with many teeth the circular spline's flank is the other half of the locus, touched by each
/// profile point at its own eta.
#include <cmath>
#include <iostream>
#include <numbers>

#include "hdconj/read_scene.hpp"
#include "hdconj/solve.hpp"
#include "support/catch.hpp"

namespace hdconj::test::rack_limit_cases {

namespace {

constexpr double module = 0.25;

Solution drive_of(int teeth, int waves, double kappa, double alpha_deg)
{
    double const size = module * waves / 2;
    std::string const text =
        "[drive]\nmodule = 0.25\nflexspline_teeth = " + std::to_string(teeth) +
        "\ncircular_spline_teeth = " + std::to_string(teeth + waves) +
        "\n[flexspline]\nwall = 0.7\n[flexspline.profile]\nfamily = \"s-tooth\"\naddendum = " +
        std::to_string(1.4 * size * kappa / 2) + "\ndedendum = " + std::to_string(2 * size * kappa) +
        "\nthickness = 0.39\ndeflection = " + std::to_string(kappa) +
        "\npressure_angle_deg = " + std::to_string(alpha_deg) +
        "\n[wave_generator]\nfamily = \"cosine\"\nradial_deformation = " + std::to_string(kappa * size) +
        "\nwaves = " + std::to_string(waves) + "\n";
    return solve(parse_scene(text, "rack limit"));
}

struct RackDeviation
{
    double point = 0;   ///< of a contact from M + L(eta_M)/2 + L(eta)/2
    double normal = 0;  ///< across the flank only
    int contacts = 0;
};

/// Contacts of the right flank at eta = n phi, against the locus' other half.
RackDeviation deviation(Solution const& drive, int waves, double kappa, double alpha)
{
    double const size = module * waves / 2;
    auto const locus = [&](double eta) {
        return Vec2(size / waves * (eta - kappa * std::sin(eta)), kappa * size * std::cos(eta));
    };
    auto const slope = [&](double eta) {
        return Vec2(size / waves * (1 - kappa * std::cos(eta)), -kappa * size * std::sin(eta));
    };
    double low = kappa < 1 ? std::acos(kappa) : 0.01;
    double high = 3;
    for (int k = 0; k < 60; ++k) {
        double const eta = 0.5 * (low + high);
        (-slope(eta).x() / slope(eta).y() < std::tan(alpha) ? low : high) = eta;
    }
    double const datum = low;
    Vec2 const half_sum = Vec2(0.195, 0) + 0.5 * locus(datum);
    RackDeviation worst;
    for (BranchRecord const& branch : drive.branches) {
        if (branch.segment_name != "right locus" || branch.kind != "regular")
            continue;
        for (std::size_t i = 0; i < branch.phi.size(); ++i) {
            double const eta = waves * branch.phi[i];
            // between the datum point and the tip, away from the fold near the point of inflexion
            if (!(eta > datum + 0.4 && eta < 2.2))
                continue;
            Vec2 const wanted = half_sum + 0.5 * locus(eta);
            Vec2 const found = branch.point[i] - Vec2(0, drive.geometry.r_m + drive.geometry.pitch_line);
            worst.point = std::max(worst.point, (found - wanted).norm());
            worst.normal = std::max(worst.normal, std::abs(cross(found - wanted, slope(eta).normalized())));
            ++worst.contacts;
        }
    }
    return worst;
}

}  // namespace

TEST_CASE("S-teeth: the circular spline is the other half of the locus in the rack limit", "[touch][s-tooth]")
{
    struct Row
    {
        int waves;
        double kappa, alpha_deg;
    };
    for (Row const& row : {Row{2, 1.0, 9.0}, {2, 0.8, 24.0}, {2, 1.1, 9.0}, {3, 0.9, 14.0}}) {
        INFO(row.waves << " waves, kappa " << row.kappa);
        double before = 0;
        for (int teeth : {999, 9999, 99990}) {
            RackDeviation const found = deviation(drive_of(teeth, row.waves, row.kappa, row.alpha_deg), row.waves,
                                                  row.kappa, row.alpha_deg * std::numbers::pi / 180);
            std::cout << "rack limit, " << row.waves << " waves, kappa " << row.kappa << ", " << teeth
                      << " teeth: " << found.point << " mm, across the flank " << found.normal << " mm, "
                      << found.contacts << " contacts\n";
            CHECK(found.contacts > 20);
            // the tooth turns by about n^2 w0/r against the circular spline, which the rack limit leaves out
            CHECK(found.normal < 4 * row.waves * row.waves * module / teeth);
            // ten times the teeth, a tenth of the error
            if (before > 0)
                CHECK(found.point / before == Approx(0.1).epsilon(0.05));
            before = found.point;
        }
    }
}

}  // namespace hdconj::test::rack_limit_cases
