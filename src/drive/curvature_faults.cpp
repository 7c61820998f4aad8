// SPDX-License-Identifier: GPL-3.0-or-later
#include "curvature_faults.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "base/text.hpp"
#include "hdconj/units.hpp"
#include "scene/usual_drive.hpp"

namespace hdconj::drive {
namespace {

/// Where the neutral curve bends least.
struct Flattest
{
    /// Curvature times a positive length squared; not above 0: hollow.
    double bend = std::numeric_limits<double>::infinity();
    double where = 0;  ///< [rad]
};

Flattest flattest_place(wavegen::AnyWaveShape const& shape, double r_m)
{
    constexpr int probes = 1440;
    double const half_lobe = std::numbers::pi / shape.waves();
    Flattest found;
    for (int i = 0; i <= probes; ++i) {
        double const u = half_lobe * (2.0 * i / probes - 1);
        wavegen::RadialDisplacement const d = shape(u);
        double const rho = r_m + d.w;
        double const bend = rho * rho + 2 * d.w1 * d.w1 - rho * d.w2;
        if (!(bend >= found.bend))
            found = {bend, u};
    }
    return found;
}

/// The largest radial deformation below that of @p choice that leaves no hollow, by halving, rounded down to what a
/// user types; 0 where there is none.
double largest_deformation(scene::FamilyChoice choice, wavegen::WaveGeneratorPlace const& place)
{
    constexpr std::string_view key = "radial_deformation";
    constexpr int halvings = 40;
    double low = 0, high = choice.number(key).value_or(0);
    for (int i = 0; i < halvings; ++i) {
        double const middle = (low + high) / 2;
        choice.given.find(key)->second.value = middle;
        Faults faults;
        wavegen::AnyWaveShape const shape = wavegen::build_wave_shape(choice, place, faults);
        bool const convex = faults.empty() && flattest_place(shape, place.r_m).bend > 0;
        (convex ? low : high) = middle;
    }
    if (!(low > 0))
        return 0;
    double const step = std::pow(10.0, std::floor(std::log10(low)) - 3);
    return std::floor(low / step) * step;
}

}  // namespace

void validate_curvature(Scene const& scene, wavegen::AnyWaveShape const& shape, double r_m, Faults& faults)
{
    Flattest const flattest = flattest_place(shape, r_m);
    if (flattest.bend > 0)
        return;
    scene::FamilyChoice const& choice = scene.wave_generator.shape;
    std::string const reason =
        fmt::format("the neutral curve would be hollow at {:g} degrees from the major axis", to_deg(flattest.where));
    if (!choice.has("radial_deformation")) {
        faults.push_back({choice.path + ".file", choice.line_of("file"), choice.text_of("file"), reason,
                          "write smaller radial displacements, or smooth them"});
        return;
    }
    double const largest = largest_deformation(choice, {r_m, scene.wave_generator.waves, scene.folder.string()});
    scene::Advice const usual = scene::usual_pair(scene, shape.amplitude());
    faults.push_back({choice.path + ".radial_deformation", choice.line_of("radial_deformation"),
                      choice.text_of("radial_deformation"), reason,
                      (largest > 0 ? "write at most " + at_most_text(largest) : std::string("write a smaller one")) +
                          (usual.words.empty() ? "" : "; usual is " + usual.words)});
    faults.back().set = usual.set;
}

}  // namespace hdconj::drive
