// SPDX-License-Identifier: GPL-3.0-or-later
// ContactOptions::errors: a search asks for figures alone.
#include <bit>
#include <cstdint>

#include "figures/contact_figures.hpp"
#include "hdconj/contact.hpp"
#include "support/catch.hpp"
#include "support/coned_drive.hpp"

namespace hdconj::test::without_errors_cases {

namespace {

/// Compares two records by all figures: the same bits but for what follows from errors, which only @p with has.
template <class Record>
void compare(figures::Rows<Record> const& rows, Record const& with, Record const& without, int& estimated)
{
    for (auto const& row : rows) {
        if (std::string_view(row.name) == "seconds" || std::string_view(row.name) == "estimated")
            continue;
        CAPTURE(row.name);
        if (row.bound)
            CHECK(row.value(without) == 0);
        else
            CHECK(std::bit_cast<std::uint64_t>(row.value(with)) == std::bit_cast<std::uint64_t>(row.value(without)));
        if (row.error == nullptr)
            continue;
        CHECK(row.error(without) == 0);
        estimated += row.error(with) > 0 ? 1 : 0;
    }
}

}  // namespace

TEST_CASE("contact without errors: the same bits, and no error is estimated", "[contact]")
{
    for (char const* const clearance : {"0", "0.09"}) {
        CAPTURE(clearance);
        Scene const scene = read_scene(
            file_of("type-50-coned"),
            {"slices.count=3", "contact.flank_points=30", std::string("circular_spline.backlash_offset=") + clearance});
        ContactOptions options;
        options.surfaces = {ToothSurface::tilted, ToothSurface::ruled, ToothSurface::per_slice};
        options.revolution = 2;
        ContactStudy const with = study_contact(scene, options);
        options.errors = false;
        ContactStudy const without = study_contact(scene, options);
        CHECK(with.estimated);
        CHECK_FALSE(without.estimated);
        REQUIRE(with.cases.size() == without.cases.size());
        REQUIRE(!with.cases.empty());
        int estimated = 0;
        for (std::size_t i = 0; i < with.cases.size(); ++i) {
            ContactCase const& a = with.cases[i];
            ContactCase const& b = without.cases[i];
            compare(figures::case_figures(), a, b, estimated);
            REQUIRE(a.revolution.size() == b.revolution.size());
            for (std::size_t j = 0; j < a.revolution.size(); ++j)
                compare(figures::state_figures(), a.revolution[j], b.revolution[j], estimated);
            for (std::size_t k = 0; k < a.slices.size(); ++k) {
                compare(figures::closest_figures(), {a.slices[k].flank, a.slices[k].flank_error},
                        {b.slices[k].flank, b.slices[k].flank_error}, estimated);
                compare(figures::closest_figures(), {a.slices[k].root, a.slices[k].root_error},
                        {b.slices[k].root, b.slices[k].root_error}, estimated);
            }
        }
        CHECK(with.map.gap == without.map.gap);
        CHECK(estimated > 50);
    }
}

}  // namespace hdconj::test::without_errors_cases
