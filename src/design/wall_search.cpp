// SPDX-License-Identifier: GPL-3.0-or-later
#include "wall_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <tuple>

#include "base/text.hpp"
#include "hdconj/contact.hpp"
#include "hdconj/load.hpp"
#include "hdconj/units.hpp"
#include "torque_search.hpp"
#include "wishes.hpp"

namespace hdconj::design {
namespace {

constexpr int told_digits = 3;
constexpr std::array walls_without_torque{0.014, 0.013, 0.012, 0.011, 0.01};  // over the pitch diameter

/// The mesh with @p wall over the pitch diameter as the wishes alone make it.
MeshedSheet mesh_with(DesignWishes const& wishes, double wall)
{
    MeshedSheet made{sheet_of(wishes, wall), {}, {}};
    made.mesh = search_mesh(made.sheet, wishes, 0);
    return made;
}

}  // namespace

bool is_better(WallTrial const& a, WallTrial const& b)
{
    auto const badness = [](WallTrial const& trial) {
        double const most = std::max(trial.assembled, trial.loaded);
        return std::tuple(most == 0, trial.interferes, most);
    };
    return badness(a) < badness(b);
}

Sheet sheet_of(DesignWishes const& wishes, double wall, ConeNeed const& cone)
{
    Sheet sheet = drive_rows(wishes);
    add_tooth_rows(sheet, wishes);
    add_body_rows(sheet, wishes, wall, cone);
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
    MeshedSheet made;
    for (double const wall : walls_without_torque) {
        made = mesh_with(wishes, wall);
        auto const& trials = made.mesh.trials;
        bool const thinner_may_do =
            std::any_of(trials.begin(), trials.end(), [](MeshTrial const& trial) { return trial.wall_stress; });
        if (made.mesh.best || !thinner_may_do)
            break;
    }
    return made;
}

std::optional<double> least_bending_with_wall(DesignWishes const& wishes)
{
    std::optional<double> least;
    for (auto wall = walls_without_torque.rbegin(); wall != walls_without_torque.rend() && !least; ++wall)
        least = least_bending(sheet_of(wishes, *wall), wishes);
    return least;
}

bool has_mesh_with_wall(DesignWishes const& wishes)
{
    for (double const wall : walls_without_torque) {
        MeshAnswer const answer = any_mesh(sheet_of(wishes, wall), wishes);
        if (answer.found || !answer.wall_stress)
            return answer.found;
    }
    return false;
}

WallTrial stress_of(MeshedSheet const& made, DesignWishes const& wishes, bool errors)
{
    WallTrial trial;
    trial.wall = made.sheet["delta"];
    LoadOptions options;
    options.curve = false;
    options.torque = wishes.torque;
    options.errors = errors;
    try {
        LoadStudy const study = study_load(scene_of(made.rows()), options);
        LoadCase const& only = study.cases.front();
        trial.assembled = study.cup.largest_stress;
        trial.loaded = only.curve[only.rated].largest_stress;
        trial.side_clearance = only.backlash_offset;
        trial.tip_radius = only.tip;
        trial.error = only.estimated ? only.error.largest_stress : 0;
        double const most = std::max(trial.assembled, trial.loaded);
        if (most > allowed_stress(wishes))
            trial.refusal = "the largest stress of the cup is " + short_number(most, told_digits) + " MPa, and " +
                            short_number(allowed_stress(wishes), told_digits) + " MPa are allowed";
    } catch (NumericalError const& error) {
        error.rethrow_unless_infeasible();
        trial.refusal = error.what();
    }
    return trial;
}

namespace {

/// What the coned cup needs of the circular spline so that no tooth is entered over a turn; the stress is left out.
WallTrial cone_need(MeshedSheet const& made)
{
    WallTrial trial;
    trial.wall = made.sheet["delta"];
    ContactOptions options;
    options.errors = false;
    try {
        ContactCase const only = study_contact(scene_of(made.rows()), options).cases.front();
        trial.side_clearance = std::max(only.least_side_clearance, only.backlash_offset);
        trial.tip_radius = only.tip;
    } catch (NumericalError const& error) {
        error.rethrow_unless_infeasible();
        trial.interferes = true;
        trial.refusal = "the coned cup leaves no clear ring: " + error.cause();
    }
    return trial;
}

/// The circular spline that the rows of @p made have.
ConeNeed ring_of(MeshedSheet const& made)
{
    CircularSpline const ring = scene_of(made.rows()).circular_spline;
    return {ring.backlash_offset, *ring.inner_radius};
}

/// Whether @p ring leaves clear what was tried.
bool is_clear(WallTrial const& trial, ConeNeed const& ring)
{
    return !trial.interferes && trial.side_clearance <= ring.clearance && trial.tip_radius <= ring.tip_radius;
}

/// Why no mesh leaves the coned cup clear.
std::string without_mesh(ConeNeed const& cone, MeshChoice const& tried)
{
    return "the coned cup needs a side clearance of " + short_number(cone.clearance) + " mm and a tip radius of " +
           short_number(cone.tip_radius) + " mm, with which " +
           (tried.best ? "another radial deformation is the best, which needs more" : usual_refusal(tried));
}

/// @p made, clear with what earlier rounds needed, or where that is clear too the mesh with its side clearance alone:
/// those rounds had other clearances and deformations, whose tip circles this one may not need.
MeshedSheet without_kept_tip(MeshedSheet made, DesignWishes const& wishes, double wall, bool errors)
{
    MeshedSheet free{sheet_of(wishes, wall, {ring_of(made).clearance, 0}), {}, {}};
    free.mesh = search_mesh(free.sheet, wishes, 0, made.mesh.cups);
    if (!free.mesh.best)
        return made;
    MeshTrial const &kept = made.mesh.trials[*made.mesh.best], &other = free.mesh.trials[*free.mesh.best];
    if (other.ratio == kept.ratio && other.tip_radius == kept.tip_radius)
        return made;
    ConeNeed const ring = ring_of(free);
    if (!is_clear(cone_need(free), ring))
        return made;
    free.walls = {stress_of(free, wishes, errors)};
    return is_clear(free.walls.back(), ring) ? free : made;
}

/// @p made, the mesh with @p wall as wished, or one whose side clearance and tip circle leave the coned cup clear, and
/// its stress. Each round starts from what the one before needs; another radial deformation may need more. A wall
/// without any mesh has no stress.
MeshedSheet mesh_with_cone(MeshedSheet made, DesignWishes const& wishes, double wall, bool errors)
{
    constexpr int rounds = 8, digits_of_tip = 6;
    ConeNeed cone;
    for (int i = 0; made.mesh.best; ++i) {
        bool const has_stress = !made.walls.empty();
        WallTrial const need = has_stress ? made.walls.back() : cone_need(made);
        bool const clear = is_clear(need, ring_of(made));
        if (clear && has_stress)
            return cone.tip_radius > 0 ? without_kept_tip(std::move(made), wishes, wall, errors) : made;
        if (need.interferes) {
            made.walls = {need};
            break;
        }
        if (clear) {
            made.walls = {stress_of(made, wishes, errors)};
            continue;
        }
        cone = {std::max(cone.clearance, rounded_up(need.side_clearance)),
                std::max(cone.tip_radius, rounded_up(need.tip_radius, digits_of_tip))};
        MeshedSheet next{sheet_of(wishes, wall, cone), {}, {}};
        next.mesh = search_mesh(next.sheet, wishes, cone.tip_radius, made.mesh.cups);
        if (!next.mesh.best || i == rounds) {
            made.walls = {stress_of(made, wishes, errors)};
            made.walls.back().interferes = true;
            made.walls.back().refusal = without_mesh(cone, next.mesh);
            break;
        }
        made = std::move(next);
    }
    return made;
}

}  // namespace

MeshedSheet WallSearch::loaded(double wall, bool errors)
{
    auto const [at, is_new] = clear_.try_emplace(wall);
    MeshedSheet& made = at->second;
    if (is_new) {
        bool const is_known = as_wished_ && as_wished_->sheet["delta"] == sheet_of(wishes_, wall)["delta"];
        made = mesh_with_cone(is_known ? *as_wished_ : mesh_with(wishes_, wall), wishes_, wall, errors);
        made.mesh.cups.clear();  // large, and no torque asks for another mesh
    } else if (made.mesh.best) {
        WallTrial const before = std::exchange(made.walls.back(), stress_of(made, wishes_, errors));
        if (before.interferes) {
            made.walls.back().interferes = true;
            made.walls.back().refusal = before.refusal;
        }
    }
    return made;
}

MeshedSheet WallSearch::best(bool errors)
{
    as_wished_ = mesh_with_wall(wishes_);
    MeshedSheet best = *as_wished_;
    if (!wishes_.torque || !best.mesh.best)
        return best;
    std::vector<WallTrial> tried;
    auto const try_walls = [&](std::initializer_list<double> walls) {
        for (double const wall : walls) {
            if (talk_)
                talk_("stress with a wall of " + short_number(wall * best.sheet["d_r"], told_digits) + " mm");
            MeshedSheet const made = loaded(wall, errors);
            if (!made.mesh.best)
                continue;
            WallTrial const& trial = made.walls.back();
            tried.push_back(trial);
            if (best.walls.empty() || trial.refusal.empty() || is_better(trial, best.walls.back()))
                best = made;
            if (trial.refusal.empty())
                return;
        }
    };
    // the first is that of type-50; bending asks for a thinner wall, torque for a thicker one
    try_walls({0.014, 0.012, 0.01, 0.015});
    if (best.walls.empty())
        try_walls({0.013, 0.011});  // the others of mesh_with_wall()
    // what was tried in order, the one that is taken last
    std::erase_if(tried, [&](WallTrial const& each) { return each.wall == best.walls.back().wall; });
    best.walls.insert(best.walls.begin(), tried.begin(), tried.end());
    return best;
}

std::optional<double> WallSearch::most_torque()
{
    double const allowed = allowed_stress(wishes_), diameter = module_of(wishes_) * teeth_of(wishes_);
    // sixteen times that of type-50 for the same stress: what is far above tells nothing
    double const far = 16 * 28 * newton_metre * std::pow(diameter / 50, 3);
    std::vector<double> walls;
    std::vector<WallTrial> refused;
    for (auto const& [wall, made] : clear_) {
        if (!made.mesh.best || made.walls.back().interferes || made.walls.back().assembled > allowed)
            continue;
        walls.push_back(wall);
        refused.push_back(made.walls.back());
    }
    return design::most_torque(refused, *wishes_.torque, allowed, far, [&](std::size_t number, double torque) {
        wishes_.torque = torque;
        if (talk_)
            talk_("stress under " + short_number(torque / newton_metre) + " N m with a wall of " +
                  short_number(walls[number] * diameter, told_digits) + " mm");
        return loaded(walls[number], false).walls.back();
    });
}

void add_root_clearance(MeshedSheet& made)
{
    ContactCase const found = study_contact(scene_of(made.rows())).cases.front();
    if (found.least_root_clearance == 0)
        return;
    double const least = rounded_up(found.least_root_clearance + found.least_root_clearance_error);
    made.sheet.add({"root clearance", "", "circular_spline.root_clearance",
                    "tips of the coned cup clear the bottom of the space", DesignRange{least, DesignRange().high},
                    least, "mm", "contact", DesignOrigin::computed, ""});
}

}  // namespace hdconj::design
