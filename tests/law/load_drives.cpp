// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Random drives under torque: every torque has an equilibrium, on every surface.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "hdconj/error.hpp"
#include "hdconj/load.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/units.hpp"
#include "support/catch.hpp"
#include "support/elastic_drives.hpp"
#include "support/run/full_run.hpp"

namespace hdconj::test::load_drives_cases {
namespace {

/// What a number of drives came to.
struct Count
{
    int refused = 0;  ///< drives whose tooth or cup is none
    int states = 0;
    int most_iterations = 0;
};

void check_case(LoadCase const& known, int sectors, Count& count)
{
    for (UnsettledTorque const& each : known.unsettled)
        FAIL_CHECK(to_string(known.surface) << ": " << each.torque / newton_metre << " N m: " << each.cause);
    double last = -1;
    for (LoadedState const& state : known.curve) {
        INFO(to_string(known.surface) << " at " << state.torque / newton_metre << " N m");
        ++count.states;
        count.most_iterations = std::max(count.most_iterations, state.iterations);
        CHECK(state.twist > last);
        CHECK((state.torque == 0 || state.stiffness > 0));
        last = state.twist;
    }
    double sum = 0;
    for (ContactForce const& contact : known.contacts)
        sum += contact.lever * contact.force;
    double const torque = known.curve[known.rated].torque;
    CHECK(sectors * sum == Approx(torque).epsilon(1e-9));
}

/// Drives of the seeds from 1 on.
/// @param torques       of the curve, even
/// @param all_surfaces  false: each drive with one of them
Count check_drives(unsigned drives, int torques, bool all_surfaces)
{
    constexpr std::array surfaces{ToothSurface::tilted, ToothSurface::ruled, ToothSurface::per_slice};
    Count count;
    for (unsigned seed = 1; seed <= drives; ++seed) {
        INFO("seed " << seed);
        designs::ElasticDrive const drive = designs::elastic_drive(seed);
        scene::SceneReading reading = examine_scene(drive.scene, "seed");
        examine_geometry(reading);
        LoadOptions options;
        options.torque = drive.torque * newton_metre;
        options.points = torques;
        options.errors = full_run();
        if (all_surfaces)
            options.surfaces.assign(surfaces.begin(), surfaces.end());
        else
            options.surfaces = {surfaces[seed % surfaces.size()]};
        if (!reading.faults.empty() || !check_load(reading.scene, options).empty()) {
            ++count.refused;
            continue;
        }
        LoadStudy const study = study_load(reading.scene, options);
        for (std::string const& missing : study.missing)
            FAIL_CHECK(missing);
        for (LoadCase const& each : study.cases)
            check_case(each, study.sectors, count);
    }
    WARN(drives << " drives, " << count.refused << " refused: " << count.states << " states, at most "
                << count.most_iterations << " iterations");
    return count;
}

}  // namespace

TEST_CASE("every torque of a random drive has an equilibrium", "[load]")
{
    Count const count = check_drives(3, 5, false);
    CHECK(count.refused <= 1);
    CHECK(count.most_iterations < 100);
}

TEST_CASE("flanks that fit a tooth over a long stretch, or lose an equilibrium, settle", "[load]")
{
    struct Drive
    {
        unsigned seed;
        double torque;  // N m
        ToothSurface surface;
    };
    for (Drive const& each : {Drive{270, 54.7341, ToothSurface::per_slice},
                              {144, 12.0576, ToothSurface::ruled},
                              {38, 163.145, ToothSurface::ruled},
                              {224, 4.85961, ToothSurface::tilted}}) {
        INFO("seed " << each.seed);
        LoadOptions options;
        options.torque = each.torque * newton_metre;
        options.curve = options.errors = false;
        options.surfaces = {each.surface};
        LoadStudy const study = study_load(parse_scene(designs::elastic_drive(each.seed).scene, "seed"), options);
        REQUIRE(study.cases.size() == 1);
        Count count;
        check_case(study.cases.front(), study.sectors, count);
        CHECK(count.states == 1);
    }
}

TEST_CASE("the same of 300 drives at 20 torques", "[.][load-of-300]")
{
    Count const count = check_drives(300, 20, true);
    CHECK(count.refused < 30);
    CHECK(count.most_iterations < 400);  // the worst of 41,172 states took 348
}

}  // namespace hdconj::test::load_drives_cases
