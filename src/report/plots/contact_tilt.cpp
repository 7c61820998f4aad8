// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "hdconj/units.hpp"
#include "plot.hpp"
#include "plots.hpp"

namespace hdconj::report {
namespace {

/// The cases of one surface and kind, by tilt.
struct TiltCurve
{
    ToothSurface surface = ToothSurface::tilted;
    std::optional<TiltKind> kind;  ///< nothing without a tilt
    std::vector<ContactCase const*> cases;

    [[nodiscard]] bool is_level() const { return cases.size() == 1; }
    [[nodiscard]] std::string name() const
    {
        return fmt::format("{}{}{}{}", to_string(surface), kind ? ", " : "", to_string(kind),
                           is_level() && !kind ? " (no tilt)" : "");
    }
};

/// Without a tilt all kinds are one: such a case begins the curves of all kinds of its surface, where there are any.
void share_untilted(std::vector<TiltCurve>& curves)
{
    for (std::size_t i = 0; i < curves.size(); ++i) {
        if (curves[i].kind)
            continue;
        bool shared = false;
        for (auto& curve : curves) {
            if (curve.surface == curves[i].surface && curve.kind) {
                curve.cases.insert(curve.cases.begin(), curves[i].cases.begin(), curves[i].cases.end());
                shared = true;
            }
        }
        if (shared)
            curves.erase(curves.begin() + static_cast<std::ptrdiff_t>(i--));
    }
}

std::vector<TiltCurve> tilt_curves(std::vector<ContactCase> const& cases)
{
    std::vector<TiltCurve> curves;
    for (auto const& each : cases) {
        auto curve = std::find_if(curves.begin(), curves.end(), [&](TiltCurve const& known) {
            return known.surface == each.surface && known.kind == each.kind;
        });
        if (curve == curves.end())
            curve = curves.insert(curve, {each.surface, each.kind, {}});
        curve->cases.push_back(&each);
    }
    share_untilted(curves);
    for (auto& curve : curves) {
        std::stable_sort(curve.cases.begin(), curve.cases.end(),
                         [](auto const* a, auto const* b) { return a->tilt < b->tilt; });
    }
    return curves;
}

}  // namespace

bool has_tilt_curve(ContactStudy const& study)
{
    auto const curves = tilt_curves(study.cases);
    return std::any_of(curves.begin(), curves.end(),
                       [](TiltCurve const& curve) { return curve.cases.front()->tilt < curve.cases.back()->tilt; });
}

std::string tilt_script(ContactStudy const& study)
{
    auto const curves = tilt_curves(study.cases);
    double tilt_low = 0, tilt_high = 0;
    for (auto const& each : study.cases) {
        tilt_low = std::min(tilt_low, each.tilt * per_deg);
        tilt_high = std::max(tilt_high, each.tilt * per_deg);
    }
    PlotColumns points, names, bests;
    for (auto const& curve : curves) {
        auto const add = [&](double tilt, ContactCase const& each) {
            points.row(tilt, each.state.contact_fraction * per_percent, each.least_side_clearance * per_um);
        };
        // One with no tilt of its own goes across the whole picture.
        for (auto const* each : curve.cases)
            add(curve.is_level() ? tilt_low : each->tilt * per_deg, *each);
        if (curve.is_level())
            add(tilt_high, *curve.cases.front());
        points.end_index();
        names.named_row(curve.name(), curve.is_level());
    }
    for (auto const& best : study.best) {
        auto const curve = std::find_if(curves.begin(), curves.end(), [&](TiltCurve const& each) {
            return each.kind == best.kind && !each.is_level();
        });
        bool const area = best.goal == TiltGoal::contact_area;
        bests.row(curve == curves.end() ? 0 : curve - curves.begin() + 1, best.tilt * per_deg,
                  best.value * (area ? per_percent : per_um), area, best.on_bound);
    }
    PlotData data(study.solution.scene.drive.name);
    data.set("contact_gap", study.contact_gap * per_um);
    data.set("tilt_low", tilt_low);
    data.set("tilt_high", tilt_high);
    data.set("curves", points);
    data.set("names", names);
    data.set("best", bests);
    return plot_script("contact_tilt", data);
}

}  // namespace hdconj::report
