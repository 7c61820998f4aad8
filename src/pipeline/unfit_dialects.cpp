// SPDX-License-Identifier: GPL-3.0-or-later
// Dialects that have no room for a program, and the tolerance that gives it to them.
#include <fmt/format.h>

#include <iterator>
#include <optional>
#include <sstream>

#include "hdconj/scene/reading.hpp"
#include "hdconj/solve.hpp"
#include "hdconj/wire_files.hpp"

namespace hdconj {
namespace {

/// Whether the wire passes its checks and all @p dialects can hold its program.
bool fits(Scene const& scene, std::vector<std::string> const& dialects, Solution const* solved)
{
    try {
        auto const programs = solved != nullptr ? WireSetUps{wire_program(scene, *solved)} : wire_set_ups(scene);
        return unfit_dialects(programs, dialects).empty();
    } catch (NumericalError const& error) {
        if (error.code() != ErrorCode::failed_check && !error.is_infeasible())
            throw;
        return false;
    } catch (InputError const&) {
        return false;  // the wire leaves too much
    }
}

/// The least of some coarser tolerances with which @p dialects hold the program; nothing where none does.
std::optional<double> fitting_tolerance(Scene scene, std::vector<std::string> const& dialects, Solution const* solved)
{
    std::optional<Solution> here;
    if (scene.wedm->part == WirePart::flexspline) {
        solved = nullptr;
    } else if (solved == nullptr) {
        here = solve(wire_scene(scene));
        solved = &*here;
    }
    double& tolerance = scene.wedm->tolerance;
    double const first = tolerance;
    constexpr double finest = 1e-6;  // no machine's grid is finer [mm]
    for (double power = finest; power < scene.drive.module; power *= 10) {
        for (double const digit : {1.0, 2.0, 4.0, 6.0, 8.0}) {
            tolerance = digit * power;
            if (tolerance > first && check_wedm(scene).empty() && fits(scene, dialects, solved))
                return tolerance;
        }
    }
    return {};
}

}  // namespace

std::vector<std::string> named_dialects(Scene const& scene)
{
    std::istringstream words(scene.wedm->dialects);
    return {std::istream_iterator<std::string>(words), {}};
}

Faults check_named_dialects(Scene const& scene)
{
    Faults faults = check_dialects(named_dialects(scene), "wedm.dialects");
    scene::locate(faults, scene);
    return faults;
}

void settle_unfit_dialects(WireSetUps& programs, Scene const& scene, std::vector<std::string> const& dialects,
                           Solution const* solved)
{
    for (auto const& unfit : unfit_dialects(programs, dialects)) {
        if (dialects.empty()) {
            programs.front().left_out.push_back(
                fmt::format("dialect {}: {}: {}; {}", unfit.name, unfit.place, unfit.cause,
                            unfit.decimals ? fmt::format("with wedm.decimals = {} it is written", *unfit.decimals)
                                           : fmt::format("--dialect {} says what to write for it", unfit.name)));
            continue;
        }
        auto const tolerance = fitting_tolerance(scene, dialects, solved);
        std::string const remedy = tolerance ? fmt::format("wedm.tolerance = {:g}, or ", *tolerance) : "";
        throw NumericalError(ErrorCode::no_room, "wire files", fmt::format("{}, {}", unfit.name, unfit.place),
                             unfit.cause, "write " + remedy + "another dialect");
    }
}

}  // namespace hdconj
