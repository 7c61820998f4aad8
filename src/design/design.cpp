// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/design.hpp"

#include <algorithm>
#include <stdexcept>

#include "base/text.hpp"
#include "hdconj/units.hpp"
#include "length_search.hpp"
#include "nearest_wishes.hpp"
#include "same_value.hpp"
#include "wall_search.hpp"
#include "wishes.hpp"

namespace hdconj {
namespace design {
namespace {

/// A pitch diameter that is not as asked for, and what the rows remark.
std::vector<std::string> remarks_on(Design const& made)
{
    std::vector<std::string> remarks;
    DesignWishes const& wishes = made.wishes;
    double const diameter = made.scene.drive.module * made.scene.drive.flexspline_teeth;
    if (wishes.diameter && !agree(diameter, *wishes.diameter))
        remarks.push_back("d_r = " + short_number(diameter) + " mm is the nearest to --diameter " +
                          short_number(*wishes.diameter) + " that a standard module makes; --module " +
                          short_number(*wishes.diameter / made.scene.drive.flexspline_teeth) + " makes it exact");
    if (!wishes.torque)
        remarks.emplace_back(
            "without --torque the wall is chosen for the bending of its ring alone; the assembled cup may be stressed "
            "more");
    for (auto const& row : made.rows)
        if (!row.remark.empty())
            remarks.push_back((row.symbol.empty() ? row.name : row.symbol) + ": " + row.remark);
    return remarks;
}

/// Adds what was computed with the scene.
void add_results(Design& design, MeshedSheet const& made)
{
    double const open = DesignRange().high;
    auto const add = [&](std::string name, std::string rule, DesignRange range, double value, std::string unit,
                         std::string source, std::string remark = {}) {
        constexpr int digits = 4;
        design.rows.push_back({std::move(name), "", "", std::move(rule), range, rounded(value, digits), std::move(unit),
                               std::move(source), DesignOrigin::figure, std::move(remark)});
    };
    MeshTrial const& mesh = made.mesh.trials[*made.mesh.best];
    add(spline_land_row, "as asked for", {design.wishes.land, open}, mesh.land, "modules", "solve");
    add(flank_contact_row, "at least 1, usually 2", {1, open}, mesh.flank_contact, "1", "solve");
    add(lost_row, "at most 0.1", {0, 0.1}, mesh.lost, "1", "solve");
    if (made.walls.empty())
        return;
    WallTrial const& wall = made.walls.back();
    double const fatigue = material_of(design.wishes).fatigue;
    constexpr double unconverged = 3;  // such an error says that the figure is not known, as in figures::is_unconverged
    std::string const error =
        wall.error <= 0 ? ""
                        : "+- " + short_number(wall.error, 2) + " MPa by the grid" +
                              (unconverged * wall.error > wall.loaded ? ", not converged: try more slices" : "");
    add("largest stress of the assembled cup", "sigma_-1/S", {0, allowed_stress(design.wishes)}, wall.assembled, "MPa",
        "load");
    add("the same at the rated torque", "sigma_-1/S", {0, allowed_stress(design.wishes)}, wall.loaded, "MPa", "load",
        error);
    add("safety against fatigue", "sigma_-1 over that, as asked for", {design.wishes.safety, open},
        fatigue / std::max(wall.assembled, wall.loaded), "1", "load");
}

}  // namespace
}  // namespace design

DesignRow const& Design::row(std::string_view key) const
{
    auto const found = std::find_if(rows.begin(), rows.end(), [&](DesignRow const& each) { return each.key == key; });
    if (found == rows.end())
        throw std::logic_error("no row has the key " + std::string(key));
    return *found;
}

Design design_drive(DesignWishes const& wishes, std::function<void(std::string const&)> const& talk)
{
    throw_if_any(check_design(wishes));
    if (talk)
        talk("radial deformation and tip circle");
    design::WallSearch search(wishes, talk);
    design::MeshedSheet made = search.best(true);
    if (!made.works())
        throw InputError(design::nearest_wishes(
            wishes, made, {[&] { return search.most_torque(); }, [&] { return design::least_length(wishes, talk); }}));
    if (wishes.torque)
        design::add_root_clearance(made);
    Design result;
    result.wishes = wishes;
    result.rows = made.rows();
    result.mesh = made.mesh.trials;
    result.walls = made.walls;
    result.scene = design::scene_of(result.rows);
    design::add_results(result, made);
    result.remarks = design::remarks_on(result);
    return result;
}

std::vector<ReadyDrive> const& ready_drives()
{
    // Pitch diameters that go with these sizes; the rules round them to standard modules. Torques grow about with the
    // cube of these diameters.
    static std::vector<ReadyDrive> const drives{{"size-14", 35, 9 * newton_metre},
                                                {"size-17", 43, 17 * newton_metre},
                                                {"size-20", 51, 28 * newton_metre},
                                                {"size-25", 63, 55 * newton_metre},
                                                {"size-32", 82, 120 * newton_metre}};
    return drives;
}

DesignWishes ready_wishes(std::string_view name)
{
    for (auto const& drive : ready_drives()) {
        if (drive.name != name)
            continue;
        DesignWishes wishes;
        wishes.name = name;
        wishes.diameter = drive.diameter;
        wishes.torque = drive.torque;
        constexpr double half = 0.5;
        wishes.length_ratio = half;
        return wishes;
    }
    throw std::logic_error("no ready drive is called " + std::string(name));
}

}  // namespace hdconj
