// SPDX-License-Identifier: GPL-3.0-or-later
#include "wall_search.hpp"

#include <algorithm>
#include <array>

#include "base/text.hpp"
#include "hdconj/load.hpp"
#include "wishes.hpp"

namespace hdconj::design {
namespace {

constexpr int digits = 3;

/// Larger where more stress, or no result, makes the wall a worse one.
double badness(WallTrial const& trial)
{
    double const most = std::max(trial.assembled, trial.loaded);
    return most > 0 ? most : DesignRange().high;
}

}  // namespace

Sheet sheet_of(DesignWishes const& wishes, double wall)
{
    Sheet sheet = drive_rows(wishes);
    add_tooth_rows(sheet, wishes);
    add_body_rows(sheet, wishes, wall);
    return sheet;
}

std::vector<DesignRow> MeshedSheet::rows() const
{
    std::vector<DesignRow> all = sheet.rows();
    all.insert(all.end(), mesh.rows.begin(), mesh.rows.end());
    return all;
}

MeshedSheet mesh_with_wall(DesignWishes const& wishes)
{
    constexpr std::array walls{0.014, 0.013, 0.012, 0.011, 0.01};  // over the pitch diameter
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

WallTrial stress_of(MeshedSheet const& made, DesignWishes const& wishes)
{
    WallTrial trial;
    trial.wall = made.sheet["delta"];
    LoadOptions options;
    options.curve = false;
    options.torque = wishes.torque;
    try {
        LoadStudy const study = study_load(scene_of(made.rows()), options);
        LoadCase const& only = study.cases.front();
        trial.assembled = study.cup.largest_stress;
        trial.loaded = only.curve[only.rated].largest_stress;
        trial.side_clearance = only.backlash_offset;
        trial.error = only.estimated ? only.error.largest_stress : 0;
        double const most = std::max(trial.assembled, trial.loaded);
        if (most > allowed_stress(wishes))
            trial.refusal = short_number(most, digits) + " MPa, and " + short_number(allowed_stress(wishes), digits) +
                            " MPa are allowed";
    } catch (NumericalError const& error) {
        if (!error.is_infeasible())
            throw;
        trial.refusal = error.what();
    }
    return trial;
}

MeshedSheet mesh_under_torque(DesignWishes const& wishes, std::function<void(std::string const&)> const& talk)
{
    MeshedSheet best = mesh_with_wall(wishes);
    if (!wishes.torque || !best.mesh.best)
        return best;
    std::vector<WallTrial> tried;
    // the first is that of type-50; bending asks for a thinner wall, torque for a thicker one
    for (double const wall : std::array{0.014, 0.012, 0.01, 0.015}) {
        MeshedSheet made{sheet_of(wishes, wall), {}, {}};
        made.mesh = search_mesh(made.sheet, wishes);
        if (!made.mesh.best)
            continue;
        if (talk)
            talk("stress with a wall of " + short_number(made.sheet["delta"]) + " mm");
        WallTrial const trial = stress_of(made, wishes);
        tried.push_back(trial);
        if (best.walls.empty() || trial.refusal.empty() || badness(trial) < badness(best.walls.back())) {
            best = made;
            best.walls = {trial};
        }
        if (trial.refusal.empty())
            break;
    }
    // what was tried in order, the one that is taken last
    std::erase_if(tried, [&](WallTrial const& each) { return each.wall == best.walls.back().wall; });
    best.walls.insert(best.walls.begin(), tried.begin(), tried.end());
    return best;
}

}  // namespace hdconj::design
