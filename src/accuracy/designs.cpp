// SPDX-License-Identifier: GPL-3.0-or-later
#include "designs.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <variant>

namespace hdconj::accuracy {

Scene design_near(Scene const& scene, std::uint64_t seed, int number)
{
    // square roots of primes: steps that no ratio of small numbers comes near
    static constexpr std::array<int, 16> primes{2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53};
    std::size_t dimension = 0;
    auto const between = [&](double low, double high) {
        double const step = std::sqrt(static_cast<double>(primes[dimension % primes.size()]));
        std::uint64_t const turned = (seed * 6364136223846793005ULL + 1442695040888963407ULL * (dimension + 1)) >> 11;
        double const start = static_cast<double>(turned) * 0x1p-53;
        ++dimension;
        double const place = start + step * (number + 1);
        return low + (high - low) * (place - std::floor(place));
    };
    Scene design = scene;
    design.circular_spline.inner_radius.reset();
    if (auto given = design.wave_generator.shape.given.find("radial_deformation");
        given != design.wave_generator.shape.given.end())
        if (auto* w0 = std::get_if<double>(&given->second.value))
            *w0 *= between(0.85, 1.1);
    design.flexspline.wall *= between(0.8, 1.2);
    scene::FamilyChoice& tooth = design.is_reverse() ? *design.circular_spline.profile : design.flexspline.profile;
    for (auto& [key, parameter] : tooth.given)
        if (auto* value = std::get_if<double>(&parameter.value); value != nullptr && key != "degree")
            *value *= between(0.94, 1.06);
    return design;
}

}  // namespace hdconj::accuracy
