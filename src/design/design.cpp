// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/design.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "base/text.hpp"
#include "mesh_search.hpp"
#include "nearest_wishes.hpp"
#include "sheet.hpp"
#include "wishes.hpp"

namespace hdconj {
namespace design {
namespace {

/// Rules that are broken, and a pitch diameter that is not as asked for.
std::vector<std::string> remarks_on(Design const& made)
{
    std::vector<std::string> remarks;
    DesignWishes const& wishes = made.wishes;
    double const diameter = made.scene.drive.module * made.scene.drive.flexspline_teeth;
    if (wishes.diameter && !agree(diameter, *wishes.diameter))
        remarks.push_back("d_r = " + short_number(diameter) + " mm is the nearest to --diameter " +
                          short_number(*wishes.diameter) + " that a standard module makes; --module " +
                          short_number(*wishes.diameter / made.scene.drive.flexspline_teeth) + " makes it exact");
    for (auto const& row : made.rows)
        if (!row.remark.empty())
            remarks.push_back((row.symbol.empty() ? row.name : row.symbol) + ": " + row.remark);
    return remarks;
}

}  // namespace

Sheet sheet_of(DesignWishes const& wishes, double wall)
{
    Sheet sheet = drive_rows(wishes);
    add_tooth_rows(sheet, wishes);
    add_body_rows(sheet, wishes, wall);
    return sheet;
}

MeshedSheet mesh_with_wall(DesignWishes const& wishes)
{
    constexpr std::array walls{0.014, 0.013, 0.012, 0.011, 0.01};  // over the pitch diameter; the first is type-50's
    MeshedSheet made;
    for (double const wall : walls) {
        made.sheet = sheet_of(wishes, wall);
        made.mesh = search_mesh(made.sheet, wishes);
        auto const& trials = made.mesh.trials;
        bool const thinner_may_do =
            std::any_of(trials.begin(), trials.end(), [](MeshTrial const& trial) { return trial.wall_stress; });
        if (made.mesh.best || !thinner_may_do)
            break;
    }
    return made;
}

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
    if (Faults faults = check_design(wishes); !faults.empty())
        throw InputError(std::move(faults));
    if (talk)
        talk("radial deformation and tip circle");
    design::MeshedSheet made = design::mesh_with_wall(wishes);
    if (!made.mesh.best)
        throw InputError(design::nearest_wishes(wishes, made.mesh));
    Design result;
    result.wishes = wishes;
    result.rows = made.sheet.rows();
    result.rows.insert(result.rows.end(), made.mesh.rows.begin(), made.mesh.rows.end());
    result.mesh = made.mesh.trials;
    result.scene = design::scene_of(result.rows);
    design::add_mesh_figures(result, made.mesh.trials[*made.mesh.best]);
    result.remarks = design::remarks_on(result);
    return result;
}

std::vector<ReadyDrive> const& ready_drives()
{
    // the pitch diameters that circulate with these sizes, rounded to standard modules by the rules
    static std::vector<ReadyDrive> const drives{
        {"size-14", 35}, {"size-17", 43}, {"size-20", 51}, {"size-25", 63}, {"size-32", 82}};
    return drives;
}

}  // namespace hdconj
