// SPDX-License-Identifier: GPL-3.0-or-later
#include "section_motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/text.hpp"
#include "coning.hpp"
#include "drive/elastic_cup.hpp"
#include "elastic/bent_cup.hpp"
#include "hdconj/base/parallel.hpp"
#include "hdconj/error.hpp"
#include "hdconj/wavegen/displacement_of.hpp"
#include "hdconj/wavegen/inextensional_mode.hpp"
#include "section_displacement.hpp"

namespace hdconj::surface {
namespace {

using HeightOf = std::function<double(double phi, double z)>;
using Sections = std::optional<std::vector<wavegen::MaterialDisplacement>>;

/// u_z of the planes at @p low and @p high, largest modulus over a lobe.
template <class Shift>
double largest_shift(int waves, Shift const& shift)
{
    constexpr int samples = 128;
    double largest = 0;
    for (int i = 0; i < samples; ++i)
        largest = std::max(largest, std::abs(shift(2 * std::numbers::pi / waves * i / samples)));
    return largest;
}

Sections all_sections(SectionDisplacement const& wall, HeightOf const& height_of, std::vector<double> const& z,
                      int threads)
{
    std::vector<std::optional<wavegen::MaterialDisplacement>> found(z.size());
    parallel_for(z.size(), threads, 1,
                 [&](std::size_t k) { found[k] = wall.along([&](double phi) { return height_of(phi, z[k]); }); });
    std::vector<wavegen::MaterialDisplacement> result;
    for (auto& section : found) {
        if (!section)
            return std::nullopt;
        result.push_back(std::move(*section));
    }
    return result;
}

Sections sections_of_cone(Solution const& base, wavegen::AnyWaveShape const& shape, std::vector<double> const& z,
                          int threads)
{
    if (!shape.breaks().empty())
        return std::nullopt;
    constexpr int nodes = 8;
    double const r_m = base.geometry.r_m;
    ConingMode const mode = coning_mode(*base.scene.coning);
    LinearAxialShift<wavegen::AnyWaveShape> const shift(shape, r_m, mode);
    double const largest = largest_shift(shape.waves(), [&](double phi) { return shift(phi).u_z; });
    if (!(mode.factor(z.front() - largest) > 0))
        throw NumericalError(ErrorCode::no_solution, "coning", "slice at z = " + short_number(z.front()) + " mm",
                             "the wall shifts along the axis into this plane from " + short_number(largest) +
                                 " mm behind it, which is behind the apex at z = " + short_number(mode.apex) + " mm",
                             "write a smaller circular_spline.width or coning.apex_height, or axial_shift = \"none\"");
    bool const exact = base.scene.solver.kinematics == Kinematics::exact;
    SectionDisplacement const wall(
        z.front() - largest, z.back() + largest,
        [&](double height) {
            wavegen::AnyWaveShape const scaled = shape.scaled(mode.factor(height));
            return exact ? wavegen::displacement_of(wavegen::NeutralCurve<wavegen::AnyWaveShape>(scaled, r_m))
                         : wavegen::inextensional_mode(scaled);
        },
        nodes, threads);
    return all_sections(
        wall, [&](double phi, double plane) { return plane - shift(phi).u_z; }, z, threads);
}

/// h + u_z(phi, h) = z with u_z interpolated as w and v are: what is smooth in h gives a series in phi.
Sections sections_of_cup(Solution const& base, std::vector<double> const& z, int threads)
{
    constexpr int nodes = 16;
    double const r_m = base.geometry.r_m;
    elastic::BentCup const& cup = *base.cup;
    double const middle = cup.bearing().middle;
    double largest = 0;
    for (double const end : {z.front(), z.back()}) {
        wavegen::MaterialDisplacement const shift = cup.axial_displacement(middle + end, r_m);
        largest = std::max(
            largest, largest_shift(shift.waves, [&](double phi) { return wavegen::displacement_at(shift, phi).w[0]; }));
    }
    double const low = z.front() - largest, high = z.back() + largest;
    SectionDisplacement const wall(
        low, high, [&](double height) { return drive::displacement_at(cup, height, r_m); }, nodes, threads);
    SectionDisplacement const along(
        low, high, [&](double height) { return cup.axial_displacement(middle + height, r_m); }, nodes, threads);
    auto const height_of = [&](double phi, double plane) {
        constexpr int budget = 32;  // each step gains two digits: u_z hardly depends on the height
        SectionDisplacement::Line const line = along.line(phi);
        double height = plane;
        for (int i = 0; i < budget; ++i) {
            double const next = plane - line(height).w;
            double const step = std::abs(next - height);
            height = next;
            if (step <= unit_roundoff * r_m)
                return height;
        }
        throw NumericalError(ErrorCode::no_solution, "coning", "plane at z = " + short_number(plane) + " mm",
                             "the wall's axial shift changes too fast along the axis");
    };
    return all_sections(wall, height_of, z, threads);
}

}  // namespace

Sections section_displacements(Solution const& base, wavegen::AnyWaveShape const& shape, std::vector<double> const& z,
                               int threads)
{
    Scene const& scene = base.scene;
    if (!scene.maps_axial_shift() || z.size() < 2)
        return std::nullopt;
    if (base.cup)
        return sections_of_cup(base, z, threads);
    if (scene.solver.kinematics == Kinematics::first_order)
        return std::nullopt;
    return sections_of_cone(base, shape, z, threads);
}

}  // namespace hdconj::surface
