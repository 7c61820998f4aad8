// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_search.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "base/text.hpp"
#include "conjugate/plane/solve_plane.hpp"
#include "hdconj/base/parallel.hpp"
#include "judgement/checks.hpp"
#include "scene/usual_drive.hpp"
#include "wishes.hpp"

namespace hdconj::design {
namespace {

constexpr int digits_of_radii = 6;
constexpr std::size_t tried_ratios = 21;
constexpr double drawn = 1e-4;  // chords of the outlines that are tried, in modules

/// A tip circle tried with a radial deformation.
struct Attempt
{
    MeshTrial trial;
    bool too_small = false;  ///< a larger tip circle may work
    double bending = 0;      ///< stress of the ring by bending [MPa]
};

/// The deformation ratio that is tried as number @p i.
double ratio_of(std::size_t i)
{
    double const step = (scene::largest_usual_ratio - scene::least_usual_ratio) / (tried_ratios - 1);
    return rounded(scene::least_usual_ratio + static_cast<double>(i) * step);
}

/// Whether @p note keeps a design from being taken. The land of the circular spline and the stress of the ring are
/// compared with the wishes elsewhere. Straight and involute flanks touch over little more than a pitch at best.
bool blocks(Note const& note, DesignWishes const& wishes)
{
    switch (note.code) {
        case NoteCode::land:
        case NoteCode::tooth_difference:
        case NoteCode::sharp_corner:
        case NoteCode::narrow_space:
        case NoteCode::wall_stress:
            return false;
        case NoteCode::tip_land:
            return note.figure < wishes.land;
        case NoteCode::flank_contact:
            return note.severity == Severity::warning;
        default:
            return true;
    }
}

/// The trial to take: close to the ratio 1, with which both pitch circles touch at the major axis, where that costs
/// little of the largest flank contact.
std::optional<std::size_t> best_of(std::vector<MeshTrial> const& trials)
{
    constexpr double enough = 0.95;
    double most = 0;
    for (MeshTrial const& trial : trials)
        if (trial.refusal.empty())
            most = std::max(most, trial.flank_contact);
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < trials.size(); ++i) {
        bool const taken = trials[i].refusal.empty() && trials[i].flank_contact >= enough * most;
        if (taken && (!best || std::abs(trials[i].ratio - 1) < std::abs(trials[*best].ratio - 1)))
            best = i;
    }
    return best;
}

class MeshSearch
{
  public:
    MeshSearch(Sheet const& sheet, DesignWishes const& wishes, double least_tip)
        : sheet_(sheet), wishes_(wishes), least_tip_(least_tip)
    {
    }

    /// The least tip circle that works with the deformation ratio @p ratio.
    /// @param cup  bent with this ratio; the tip circle does not change it. Null: solved here
    [[nodiscard]] Attempt operator()(double ratio, SharedCup& cup) const
    {
        auto const attempt = [&](double tip_radius) { return with_tip(ratio, tip_radius, cup); };
        double const m = sheet_["m"], w0 = rounded(ratio * m, digits_of_radii);
        Drive drive;
        drive.module = m;
        drive.flexspline_teeth = static_cast<int>(sheet_["z_f"]);
        double const usual = scene::usual_tip_radius(drive, sheet_["h_a"], sheet_["h_f"], w0);
        double low = std::max(usual, least_tip_);
        Attempt best = attempt(low);
        if (!best.too_small)
            return best;
        // where a third of the tooth is left there is no mesh to speak of
        double high = std::max(low, usual + 2 * sheet_["h_a"] / 3);
        best = attempt(high);
        constexpr double resolved = 0.01;  // modules
        while (!best.too_small && high - low > resolved * m) {
            double const middle = (low + high) / 2;
            Attempt const between = attempt(middle);
            (between.too_small ? low : high) = middle;
            if (!between.too_small)
                best = between;
        }
        return best;
    }

  private:
    [[nodiscard]] Attempt with_tip(double ratio, double tip_radius, SharedCup& cup) const
    {
        Attempt made;
        MeshTrial& trial = made.trial;
        trial.ratio = ratio;
        trial.w0 = rounded(ratio * sheet_["m"], digits_of_radii);
        trial.tip_radius = rounded(tip_radius, digits_of_radii);
        conjugate::SolvedPlane plane;
        Solution& pair = plane.solution;
        pair.cup = cup;
        try {
            pair.scene = scene_of(sheet_.rows(), mesh_rows(sheet_, wishes_, ratio, tip_radius));
            // each ratio has a thread; lands and contacts do not depend on how finely the outline is drawn
            pair.scene.solver.threads = 1;
            pair.scene.solver.tolerance = drawn * pair.scene.drive.module;
            pair.plan = make_plan(pair.scene);
            drive::StageClock clock(pair.plan, {});
            conjugate::solve_plane(plane, clock, std::nullopt);
            judge_pair(pair, made);
        } catch (NumericalError const& error) {
            error.rethrow_unless_infeasible();
            made.too_small = error.code() == ErrorCode::no_land || error.code() == ErrorCode::interference;
            trial.refusal = error.cause();
        } catch (InputError const& error) {
            trial.refusal = error.faults().front().reason;
        }
        cup = pair.cup;
        return made;
    }

    void judge_pair(Solution const& solution, Attempt& made) const
    {
        MeshTrial& trial = made.trial;
        MeshFigures const figures(solution);
        trial.land = figures.land;
        trial.flank_contact = figures.flank_contact;
        trial.lost = figures.lost;
        for (Note const& note : solution.judgement) {
            if (!blocks(note, wishes_))
                continue;
            made.too_small = made.too_small || note.code == NoteCode::late_mesh;
            if (trial.refusal.empty())
                trial.refusal = note.cause;
        }
        made.bending = judgement::bending_stress(solution.scene, solution.geometry);
        trial.wall_stress = made.bending > allowed_stress(wishes_);
        if (trial.wall_stress)
            trial.refusal = "bending the ring stresses it by " + short_number(made.bending, 3) + " MPa, and " +
                            short_number(allowed_stress(wishes_), 3) + " MPa are allowed";
        if (trial.land < wishes_.land) {
            made.too_small = true;
            trial.refusal = "the land of the circular spline is " + short_number(trial.land, 3) + " m";
        }
    }

    Sheet const& sheet_;
    DesignWishes const& wishes_;
    double least_tip_;
};

}  // namespace

MeshFigures::MeshFigures(Solution const& solution)
    : land(2 * solution.geometry.land_half_angle * solution.geometry.circular_spline_inner_radius /
           solution.scene.drive.module),
      flank_contact(solution.scene.drive.flexspline_teeth * solution.flank_contact.angle / (2 * std::numbers::pi)),
      lost(solution.flank_contact.used > 0 ? solution.flank_contact.lost / solution.flank_contact.used : 0)
{
}

std::string usual_refusal(MeshChoice const& failed)
{
    auto const nearest = std::min_element(
        failed.trials.begin(), failed.trials.end(),
        [](MeshTrial const& a, MeshTrial const& b) { return std::abs(a.ratio - 1) < std::abs(b.ratio - 1); });
    return "no radial deformation from 0.8 to 1.2 m (z_c - z_f)/2 makes a mesh; with " + short_number(nearest->w0) +
           " mm " + nearest->refusal;
}

std::vector<DesignRow> mesh_rows(Sheet const& sheet, DesignWishes const& wishes, double ratio, double tip_radius)
{
    double const m = sheet["m"];
    std::vector<DesignRow> rows;
    if (wishes.family == "s-tooth")
        rows.push_back({"deflection coefficient",
                        "kappa",
                        "flexspline.profile.deflection",
                        "2 w0/(m (z_c - z_f))",
                        {},
                        rounded(ratio, digits_of_radii),
                        "1",
                        "EP 0266972",
                        DesignOrigin::computed,
                        ""});
    rows.push_back({"wave generator",
                    "",
                    "wave_generator.family",
                    "cosine cam",
                    {},
                    std::string("cosine"),
                    "",
                    "thesis 4.2",
                    DesignOrigin::rule,
                    ""});
    rows.push_back({"radial deformation", "w_0", "wave_generator.radial_deformation",
                    "(0.8 ... 1.2) m (z_c - z_f)/2, near 1 with 95 % of the most flank contact",
                    DesignRange{scene::least_usual_ratio * m, scene::largest_usual_ratio * m},
                    rounded(ratio * m, digits_of_radii), "mm", "solve", DesignOrigin::computed, ""});
    rows.push_back({"tip radius of the circular spline",
                    "r_a",
                    "circular_spline.inner_radius",
                    "least with lands as asked and tips that part",
                    {},
                    rounded(tip_radius, digits_of_radii),
                    "mm",
                    "solve",
                    DesignOrigin::computed,
                    ""});
    return rows;
}

MeshChoice search_mesh(Sheet const& sheet, DesignWishes const& wishes, double least_tip, std::vector<SharedCup> cups)
{
    MeshChoice choice;
    choice.trials.resize(tried_ratios);
    choice.cups = std::move(cups);
    choice.cups.resize(tried_ratios);
    MeshSearch const search(sheet, wishes, least_tip);
    parallel_for(choice.trials.size(), 0, 1,
                 [&](std::size_t i) { choice.trials[i] = search(ratio_of(i), choice.cups[i]).trial; });
    choice.best = best_of(choice.trials);
    if (choice.best) {
        MeshTrial const& best = choice.trials[*choice.best];
        choice.rows = mesh_rows(sheet, wishes, best.ratio, best.tip_radius);
    }
    return choice;
}

MeshAnswer any_mesh(Sheet const& sheet, DesignWishes const& wishes)
{
    std::array<double, tried_ratios> usual_first{};
    for (std::size_t i = 0; i < usual_first.size(); ++i)
        usual_first[i] = ratio_of(i);
    std::ranges::stable_sort(usual_first, {}, [](double ratio) { return std::abs(ratio - 1); });
    std::atomic<bool> found = false, wall_stress = false;
    MeshSearch const search(sheet, wishes, 0);
    parallel_for(usual_first.size(), 0, 1, [&](std::size_t i) {
        if (found)
            return;
        SharedCup cup;
        MeshTrial const trial = search(usual_first[i], cup).trial;
        if (trial.refusal.empty())
            found = true;
        if (trial.wall_stress)
            wall_stress = true;
    });
    return {found, !found && wall_stress};
}

std::optional<double> least_bending(Sheet const& sheet, DesignWishes wishes)
{
    wishes.fatigue = std::numeric_limits<double>::infinity();
    std::array<Attempt, tried_ratios> attempts;
    MeshSearch const search(sheet, wishes, 0);
    parallel_for(attempts.size(), 0, 1, [&](std::size_t i) {
        SharedCup cup;
        attempts[i] = search(ratio_of(i), cup);
    });
    std::optional<double> least;
    for (Attempt const& each : attempts)
        if (each.trial.refusal.empty() && (!least || each.bending < *least))
            least = each.bending;
    return least;
}

}  // namespace hdconj::design
