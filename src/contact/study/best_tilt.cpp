// SPDX-License-Identifier: GPL-3.0-or-later
#include "best_tilt.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "hdconj/error.hpp"
#include "hdconj/scene/schema.hpp"
#include "hdconj/units.hpp"

namespace hdconj::contact {
namespace {

constexpr double none = std::numeric_limits<double>::infinity();

struct Found
{
    double tilt = 0;  // [rad]
    double cost = none;
};

/// What a tilt costs: the less the better, none where no surface can be made.
class TiltCost
{
  public:
    TiltCost(BestTilt& result, bool largest, std::function<double(double)> const& value)
        : result_(result), sign_(largest ? -1 : 1), value_(value)
    {
    }

    Found operator()(double tilt)
    {
        try {
            Found const found{tilt, sign_ * value_(tilt)};
            result_.possible_from = std::min(result_.possible_from, tilt);
            result_.possible_to = std::max(result_.possible_to, tilt);
            return found;
        } catch (NumericalError const& error) {
            error.rethrow_unless_infeasible();
            ++result_.refused;
            result_.refusal = error.what();
            last_.emplace(error);
            return {tilt, none};
        }
    }

    /// The value of what was found. @throws NumericalError where nothing was
    [[nodiscard]] double value_of(Found const& found) const
    {
        if (found.cost == none)
            throw NumericalError(*last_);
        return sign_ * found.cost;
    }

  private:
    BestTilt& result_;
    double sign_;
    std::function<double(double)> const& value_;
    std::optional<NumericalError> last_;
};

/// The first of the best of @p steps + 1 even tilts.
Found scanned(TiltCost& cost, double from, double to, int steps)
{
    Found best = cost(from);
    for (int i = 1; i <= steps; ++i) {
        Found const next = cost(from + (to - from) * i / steps);
        if (next.cost < best.cost)
            best = next;
    }
    return best;
}

/// Closes in on the least cost between two tilts. The cost is infinite where no surface exists: golden section only
/// compares costs, whereas the parabolas of Brent's method need finite ones.
Found golden_section(TiltCost& cost, double low, double high, double tolerance)
{
    constexpr double golden = 0.6180339887498949;
    Found a = cost(high - golden * (high - low)), b = cost(low + golden * (high - low));
    while (high - low > tolerance) {
        if (a.cost < b.cost) {
            high = b.tilt;
            b = a;
            a = cost(high - golden * (high - low));
        } else {
            low = a.tilt;
            a = b;
            b = cost(low + golden * (high - low));
        }
    }
    return a.cost < b.cost ? a : b;
}

}  // namespace

BestTilt best_tilt(TiltGoal goal, TiltKind kind, ContactOptions const& options, bool largest,
                   std::function<double(double)> const& value)
{
    constexpr int scan = 20;
    constexpr double tolerance_deg = 0.005;
    double const from = options.best_from, to = options.best_to;
    BestTilt result;
    result.goal = goal;
    result.kind = kind;
    result.tolerance = tolerance_deg * deg;
    result.from = from;
    result.to = to;
    result.possible_from = none;
    result.possible_to = -none;
    TiltCost cost(result, largest, value);
    Found best = scanned(cost, from, to, scan);
    double const step = (to - from) / scan;
    Found const closer =
        golden_section(cost, std::max(from, best.tilt - step), std::min(to, best.tilt + step), result.tolerance);
    // a bound that was scanned may still be better than what the search closed in on
    if (closer.cost < best.cost)
        best = closer;
    result.tilt = best.tilt;
    result.value = cost.value_of(best);
    result.on_bound = best.tilt - from <= result.tolerance || to - best.tilt <= result.tolerance;
    return result;
}

}  // namespace hdconj::contact
