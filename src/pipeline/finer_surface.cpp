// SPDX-License-Identifier: GPL-3.0-or-later
#include "finer_surface.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "contact_error.hpp"
#include "hdconj/axial/slice_places.hpp"
#include "moved_outline.hpp"
#include "part_flanks.hpp"

namespace hdconj::detail {

MatchedOutline surface_of(ContactBench const& bench, SurfaceMaker& maker, SurfaceChoice const& choice, double tip)
{
    MatchedOutline outline;
    bool const draft = choice.kind == "draft" && choice.tilt != 0;
    SurfaceChoice const flat{choice.surface, "radial", 0};
    bench.clock.run(Stage::surface, [&] { outline = maker(draft ? choice : flat, tip, bench.tolerance.length, bench.request.flank_points); });
    if (!draft && choice.tilt != 0)
        bench.clock.run(Stage::tilt, [&] { move_radially(outline, maker.z(), choice.tilt); });
    return outline;
}

MatchedOutline surface_of(ContactBench const& bench, SurfaceChoice const& choice, double tip)
{
    return surface_of(bench, bench.maker, choice, tip);
}

int FinerSurface::parts(std::size_t spaces) const
{
    bool const alike = !bench_.scene.coning && choice_.tilt == 0;
    if (grid_.slices() < 2 || alike)
        return 1;
    // a few planes in all would say little about what lies between them
    int parts = 2;
    while ((grid_.slices() - 1) * static_cast<std::size_t>(parts) + 1 < fewest_planes)
        parts *= 2;
    // a plane between two needs a conjugate outline, or many sections of the elastic cup
    if (solved_anew() || bench_.cup != nullptr)
        return parts;
    constexpr int most = 16;
    constexpr std::size_t most_planes = 256;
    auto const all = static_cast<std::size_t>(bench_.scene.drive.circular_spline_teeth);
    while (parts < most && static_cast<std::size_t>(parts) * spaces <= all && 2 * static_cast<std::size_t>(parts) * grid_.slices() <= most_planes)
        parts *= 2;
    return parts;
}

FlankGrid const& FinerSurface::operator()(int parts)
{
    if (parts == 1)
        return grid_;
    auto const known = known_.find(parts);
    return known != known_.end() ? known->second : known_.emplace(parts, made(parts)).first->second;
}

FlankGrid FinerSurface::made(int parts) const
{
    if (solved_anew())
    {
        SurfaceMaker* finer = &bench_.maker;
        for (int i = 1; i < parts; i *= 2)
            finer = &finer->refined();
        SurfaceMaker& maker = *finer;
        return moved_into_material(part_flanks(bench_, maker, choice_, surface_of(bench_, maker, choice_, tip_), tip_, offset_).grid, offset_);
    }
    // straight between slices: one outline moved along its radii or its normals, or the lines that a ruled surface is made of; the normals turn, along
    // which the side clearance is laid
    FlankGrid finer = bare_;
    int const slices = static_cast<int>(bare_.slices());
    finer.z = slice_places((slices - 1) * parts + 1, bench_.width);
    auto const interval = [&](std::size_t k, double& share) {
        std::size_t const low = std::min(k / static_cast<std::size_t>(parts), bare_.slices() - 2);
        share = static_cast<double>(k - low * static_cast<std::size_t>(parts)) / parts;
        return low;
    };
    auto const fill = [&](std::vector<std::vector<Vec2>> const& given, std::vector<std::vector<Vec2>>& filled, bool unit) {
        filled.clear();
        for (std::size_t k = 0; k < finer.z.size() && !given.empty(); ++k)
        {
            double share = 0;
            std::size_t const low = interval(k, share);
            filled.push_back(share == 0 ? given[low] : given[low + 1]);
            for (std::size_t i = 0; i < given[low].size() && share != 0 && share != 1; ++i)
            {
                Vec2 const p = (1 - share) * given[low][i] + share * given[low + 1][i];
                filled.back()[i] = unit ? p.normalized() : p;
            }
        }
    };
    for (std::size_t flank = 0; flank < 2; ++flank)
    {
        fill(bare_.point[flank], finer.point[flank], false);
        fill(bare_.normal[flank], finer.normal[flank], true);
        fill(bare_.line[flank], finer.line[flank], false);
        fill(bare_.line_normal[flank], finer.line_normal[flank], true);
    }
    auto const fill_numbers = [&](std::vector<double> const& given, std::vector<double>& filled) {
        filled.clear();
        for (std::size_t k = 0; k < finer.z.size() && !given.empty(); ++k)
        {
            double share = 0;
            std::size_t const low = interval(k, share);
            filled.push_back((1 - share) * given[low] + share * given[low + 1]);
        }
    };
    fill_numbers(bare_.tip, finer.tip);
    fill_numbers(bare_.shift, finer.shift);
    return moved_into_material(std::move(finer), offset_);
}

}  // namespace hdconj::detail
