// SPDX-License-Identifier: GPL-3.0-or-later
// What a gap field tells of several spaces or points at once.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "contact/gap_field.hpp"
#include "contact/resolved_area.hpp"
#include "contact/study/contact_context.hpp"
#include "hdconj/base/tolerance.hpp"
#include "hdconj/units.hpp"
#include "support/catch.hpp"
#include "support/coned_drive.hpp"

namespace hdconj::test::gaps_together_cases {

namespace {

/// Places and field that belong together.
struct Field
{
    Field(ConedDrive const& drive, contact::FlankGrid const& grid, double phase, int lobes = 1)
        : places(contact::tooth_places(*drive.context, phase, drive.context->maker.z())),
          field(drive.tooth, grid, places, drive.z_f(), drive.z_c(), phase, nullptr, lobes)
    {
    }
    contact::ToothPoses places;
    contact::GapField field;
};

}  // namespace

TEST_CASE("one lobe stands for all", "[gap_field]")
{
    ConedDrive drive(builtin_scene(coned()), 3);
    contact::FlankGrid const grid = drive.flanks(drive.surface(ToothSurface::tilted), 40);
    for (double const angle : {0.0, 0.31 * deg}) {
        double const phase = contact::phase_of(drive.scene, angle);
        Field const all(drive, grid, phase), one(drive, grid, phase, contact::lobes_of(*drive.context));
        REQUIRE(one.field.lobes() == 2);
        GapMap const found = one.field.map(0, 2), expected = all.field.map(0, 2);
        REQUIRE(found.gap.size() == expected.gap.size());
        double worst = 0;
        for (std::size_t i = 0; i < found.gap.size(); ++i)
            worst = std::max(worst, std::abs(found.gap[i] - expected.gap[i]));
        CHECK(worst < 1e-12);
        std::vector<std::size_t> spaces(all.field.spaces());
        std::iota(spaces.begin(), spaces.end(), std::size_t{0});
        std::vector<std::size_t> const lobe(
            spaces.begin() + static_cast<std::ptrdiff_t>(one.field.first_of_lobe()),
            spaces.begin() + static_cast<std::ptrdiff_t>(one.field.first_of_lobe() + one.field.spaces_of_lobe()));
        for (int const flank : {0, 1}) {
            CHECK(std::abs(contact::smallest_gap(one.field, found, 0, flank, 1).gap -
                           contact::smallest_gap(all.field, expected, 0, flank, 1).gap) < 1e-12);
            contact::ResolvedArea const a = contact::resolved_area(one.field, lobe, 0, flank, 1e-2, 7, 1, true),
                                        b = contact::resolved_area(all.field, spaces, 0, flank, 1e-2, 7, 1, true);
            CHECK(b.area.spaces > 10);
            CHECK(a.area.spaces == b.area.spaces);
            CHECK(std::abs(a.area.contact - b.area.contact) < 1e-9 * b.area.contact);
            CHECK(std::abs(a.area.whole - b.area.whole) < 1e-9 * b.area.whole);
            CHECK(std::abs(a.across - b.across) < 1e-9);
        }
    }
}

TEST_CASE("gaps of a mirrored map are those of every point by itself, and of no other map", "[gap_field]")
{
    for (std::string const shift : {"none", "mapped"}) {
        ConedDrive drive(builtin_scene(coned(shift)), 3);
        contact::FlankGrid const grid = drive.flanks(drive.surface(ToothSurface::per_slice), 20);
        // one side moved: no mirror image of the other
        contact::FlankGrid uneven = grid;
        for (Vec2& p : uneven.point[GapMap::left][1])
            p.x() -= 1e-3;
        for (int const lobes : {1, contact::lobes_of(*drive.context)})
            for (contact::FlankGrid const* const flanks : {&grid, static_cast<contact::FlankGrid const*>(&uneven)}) {
                Field const f(drive, *flanks, 0, lobes);
                GapMap const map = f.field.map(0, 2);
                std::size_t const first = f.field.first_of_lobe(), end = first + f.field.spaces_of_lobe();
                std::size_t const middle = static_cast<std::size_t>(drive.z_c() - 1) / 2;
                double worst = 0;
                int images = 0, left = 0;
                for (std::size_t space = first; space < end; ++space)
                    for (int const flank : {0, 1})
                        for (std::size_t k = 0; k < grid.slices(); ++k)
                            for (std::size_t i = 0; i < grid.points(); ++i) {
                                double const gap = map.at(space, flank, k, i);
                                worst = std::max(worst, std::abs(gap - f.field.gap({space, flank, k, i}, 0)));
                                if (flank == GapMap::right || space > 2 * middle)
                                    continue;
                                ++left;
                                images += gap == map.at(2 * middle - space, GapMap::right, k, i) ? 1 : 0;
                            }
                INFO(shift << ", " << lobes << " lobes: worst " << worst);
                CHECK(worst < 32 * unit_roundoff * f.field.reach());
                CHECK((images == left) == (flanks == &grid));
            }
    }
}

TEST_CASE("gradients of points taken together are each what it is by itself", "[gap_field]")
{
    ConedDrive drive(builtin_scene(coned()), 3);
    contact::FlankGrid const grid = drive.flanks(drive.surface(ToothSurface::tilted), 60);
    Field const f(drive, grid, 0);
    std::vector<double> gap(grid.points());
    std::vector<Vec2> gradient(grid.points());
    int others = 0;
    for (std::size_t space = 0; space < f.field.spaces(); space += 7)
        for (int const flank : {0, 1})
            for (std::size_t k = 0; k < grid.slices(); ++k) {
                auto const near = f.field.near_teeth(space, k, 1e-3);
                auto const& line = grid.point[static_cast<std::size_t>(flank)][k];
                f.field.gaps(near, flank, line.data(), line.size(), gap.data(), gradient.data());
                for (std::size_t i = 0; i < line.size(); ++i) {
                    others += gradient[i] != f.field.touch(near, line[i]).gradient() ? 1 : 0;
                    others += gap[i] != f.field.gap({space, flank, k, i}, 1e-3) ? 1 : 0;
                }
            }
    CHECK(others == 0);
}

}  // namespace hdconj::test::gaps_together_cases
