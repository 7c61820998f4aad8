// SPDX-License-Identifier: GPL-3.0-or-later
#include "refined_flanks.hpp"

#include <algorithm>
#include <vector>

#include "contact/clearance/clearance_error.hpp"
#include "contact/clearance/part_flanks.hpp"
#include "surface/slice_places.hpp"

namespace hdconj::contact {
namespace {

/// A place between two slices.
struct Between
{
    std::size_t low = 0;  ///< the slice below
    double share = 0;     ///< of the way to the slice above
};

/// The flanks @p bare with @p parts intervals in place of each between two slices. The surface is straight there: one
/// outline moved along its radii, whose normals turn, along which the side clearance is laid; or the lines of a ruled
/// surface, which has it.
FlankGrid between_slices(FlankGrid const& bare, int parts, double width)
{
    FlankGrid finer = bare;
    int const slices = static_cast<int>(bare.slices());
    finer.z = surface::slice_places((slices - 1) * parts + 1, width);
    auto const between = [&](std::size_t k) {
        std::size_t const low = std::min(k / static_cast<std::size_t>(parts), bare.slices() - 2);
        return Between{low, static_cast<double>(k - low * static_cast<std::size_t>(parts)) / parts};
    };
    auto const fill = [&](std::vector<std::vector<Vec2>> const& given, std::vector<std::vector<Vec2>>& filled,
                          bool unit) {
        filled.clear();
        for (std::size_t k = 0; k < finer.z.size() && !given.empty(); ++k) {
            auto const [low, share] = between(k);
            filled.push_back(share == 0 ? given[low] : given[low + 1]);
            for (std::size_t i = 0; i < given[low].size() && share != 0 && share != 1; ++i) {
                Vec2 const p = (1 - share) * given[low][i] + share * given[low + 1][i];
                filled.back()[i] = unit ? p.normalized() : p;
            }
        }
    };
    auto const fill_numbers = [&](std::vector<double> const& given, std::vector<double>& filled) {
        filled.clear();
        for (std::size_t k = 0; k < finer.z.size() && !given.empty(); ++k) {
            auto const [low, share] = between(k);
            filled.push_back((1 - share) * given[low] + share * given[low + 1]);
        }
    };
    for (std::size_t flank = 0; flank < 2; ++flank) {
        fill(bare.point[flank], finer.point[flank], false);
        fill(bare.normal[flank], finer.normal[flank], true);
        fill(bare.line[flank], finer.line[flank], false);
        fill(bare.line_normal[flank], finer.line_normal[flank], true);
    }
    fill_numbers(bare.tip, finer.tip);
    fill_numbers(bare.shift, finer.shift);
    return finer;
}

}  // namespace

int RefinedFlanks::parts(std::size_t spaces) const
{
    ContactContext const& context = surface_.context();
    if (surface_.is_alike())
        return 1;
    // a few planes in all would say little about what lies between them
    int parts = 2;
    while ((grid_.slices() - 1) * static_cast<std::size_t>(parts) + 1 < fewest_planes)
        parts *= 2;
    // a plane between two needs a conjugate outline, or many sections of the elastic cup
    if (solved_anew() || context.cup != nullptr)
        return parts;
    constexpr int most = 16;
    constexpr std::size_t most_planes = 256;
    auto const all = static_cast<std::size_t>(context.scene.drive.circular_spline_teeth);
    while (parts < most && static_cast<std::size_t>(parts) * spaces <= all &&
           2 * static_cast<std::size_t>(parts) * grid_.slices() <= most_planes)
        parts *= 2;
    return parts;
}

FlankGrid const& RefinedFlanks::operator()(int parts)
{
    if (parts == 1)
        return grid_;
    auto const kept = kept_.find(parts);
    return kept != kept_.end() ? kept->second : kept_.emplace(parts, made(parts)).first->second;
}

FlankGrid RefinedFlanks::made(int parts) const
{
    if (surface_.is_ruled_on_cone())
        return between_slices(grid_, parts, surface_.context().width);
    if (!solved_anew() && !surface_.is_drafted())
        return moved_into_material(between_slices(bare_, parts, surface_.context().width), offset_);
    CaseSurface finer = surface_;
    for (int i = 1; i < parts; i *= 2)
        finer = finer.refined();
    return moved_into_material(part_flanks(finer, finer.outline(tip_), tip_, offset_).grid, offset_);
}

}  // namespace hdconj::contact
