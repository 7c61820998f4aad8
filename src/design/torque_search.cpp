// SPDX-License-Identifier: GPL-3.0-or-later
#include "torque_search.hpp"

#include <algorithm>
#include <cmath>

#include "hdconj/scene/schema.hpp"
#include "hdconj/units.hpp"
#include "sheet.hpp"

namespace hdconj::design {
namespace {

constexpr int two = 2;                  // digits of a torque
constexpr int first = 10, decade = 90;  // 10, 11 ... 99

/// Torques of two digits are numbered from the least torque of a scene on.
double torque_of(int number)
{
    double const least = scene::bounds::least_torque * newton_metre;
    return rounded((first + number % decade) * least / first * std::pow(10, number / decade), two);
}

/// The number of the largest one that is no larger than @p torque.
int number_below(double torque)
{
    double const scaled = std::max(1.0, torque / (scene::bounds::least_torque * newton_metre));
    int const decades = static_cast<int>(std::log10(scaled));
    int number = decades * decade + static_cast<int>(first * scaled / std::pow(10, decades)) - first;
    while (number > 0 && torque_of(number) > torque)
        --number;
    while (torque_of(number + 1) <= torque)
        ++number;
    return number;
}

/// What is known of the torques that a wall stands.
class WallLimit
{
  public:
    WallLimit(WallTrial const& refused, double asked, double allowed, double far)
        : allowed_(allowed), far_(far), too_much_(number_below(asked) + 1)
    {
        if (torque_of(too_much_ - 1) == asked)
            --too_much_;
        learn(refused, asked);
    }

    /// The torque to try next, if the one numbered @p stands is known to be stood by some wall.
    [[nodiscard]] int next(int stands) const
    {
        constexpr int most_guesses = 6;
        double const slope = (last_.stress - before_.stress) / (last_.torque - before_.torque);
        int guess = (stands + too_much_) / 2;
        if (!known_)
            guess = number_below(std::min(far_, torque_of(too_much_) / 4));
        else if (slope > 0 && tried_ < most_guesses)
            guess = number_below(std::max(0.0, last_.torque + (allowed_ - last_.stress) / slope));
        return std::clamp(guess, stands + 1, std::max(stands + 1, too_much_ - 1));
    }
    [[nodiscard]] bool may_exceed(int stands) const { return too_much_ > stands + 1; }

    void add(int number, WallTrial const& trial)
    {
        ++tried_;
        if (!trial.refusal.empty())
            too_much_ = std::min(too_much_, number);
        learn(trial, torque_of(number));
    }

  private:
    void learn(WallTrial const& trial, double torque)
    {
        constexpr int most_failures = 4;
        double const stress = std::max(trial.assembled, trial.loaded);
        if (stress <= 0) {
            if (++failed_ > most_failures)
                too_much_ = 0;
            return;
        }
        before_ = known_ ? last_ : State{0, trial.assembled};
        last_ = {torque, stress};
        known_ = true;
        if (stress > allowed_)  // in proportion at most
            too_much_ = std::min(too_much_, number_below(torque * allowed_ / stress) + 1);
    }

    struct State
    {
        double torque = 0, stress = 0;
    };
    double allowed_, far_;
    int too_much_;  // number of a torque
    int tried_ = 0, failed_ = 0;
    bool known_ = false;  // whether there was a result
    State before_, last_;
};

}  // namespace

std::optional<double> most_torque(std::vector<WallTrial> const& refused, double asked, double allowed, double far,
                                  WallUnder const& under)
{
    constexpr double least_part = 1e-3;  // of far: less is of no use to name
    int const none = number_below(least_part * far);
    std::vector<WallLimit> limits;
    for (WallTrial const& each : refused)
        limits.emplace_back(each, asked, allowed, far);
    int stands = none;
    for (;;) {
        std::optional<std::size_t> best;
        for (std::size_t i = 0; i < limits.size(); ++i)
            if (limits[i].may_exceed(stands) && (!best || limits[i].next(stands) > limits[*best].next(stands)))
                best = i;
        if (!best)
            break;
        int const number = limits[*best].next(stands);
        WallTrial const trial = under(*best, torque_of(number));
        limits[*best].add(number, trial);
        if (trial.refusal.empty())
            stands = number;
    }
    return stands > none ? std::optional(torque_of(stands)) : std::nullopt;
}

}  // namespace hdconj::design
