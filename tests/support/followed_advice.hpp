// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What a scene comes to, and the advice that goes with it as arguments of --set.
#pragma once

#include <string>
#include <vector>

#include "hdconj/read_scene.hpp"
#include "hdconj/solve.hpp"

namespace hdconj::test {

/// What a scene comes to.
struct DesignOutcome
{
    bool solved = false;
    std::size_t warnings = 0;      ///< of the judgement
    std::vector<std::string> set;  ///< advice of the faults, the failure or the warnings
    std::string said;              ///< their text

    [[nodiscard]] bool clean() const { return solved && warnings == 0; }
};

/// The key of an argument of --set.
inline std::string key_of(std::string const& set)
{
    return set.substr(set.starts_with('!') ? 1 : 0, set.find('=') - (set.starts_with('!') ? 1 : 0));
}

/// Adds @p more to @p set; what is said first of a key holds.
inline void add_advice(std::vector<std::string>& set, std::vector<std::string> const& more)
{
    for (std::string const& each : more)
        if (std::none_of(set.begin(), set.end(), [&](auto const& other) { return key_of(other) == key_of(each); }))
            set.push_back(each);
}

/// Reads and solves @p text with @p overrides.
inline DesignOutcome outcome_of(std::string const& text, std::vector<std::string> const& overrides = {})
{
    DesignOutcome outcome;
    try {
        auto reading = examine_scene(text, "novice", {}, overrides);
        examine_geometry(reading);
        if (!reading.faults.empty())
            throw InputError(reading.faults);
        Solution const solution = solve(reading.scene);
        outcome.solved = true;
        outcome.warnings = warnings_of(solution.judgement);
        outcome.said = describe(solution.judgement);
        for (Note const& note : solution.judgement)
            if (note.severity == Severity::warning)
                add_advice(outcome.set, note.set);
    } catch (InputError const& error) {
        outcome.said = error.what();
        for (Fault const& fault : error.faults())
            add_advice(outcome.set, fault.set);
    } catch (NumericalError const& error) {
        outcome.said = error.what();
        add_advice(outcome.set, error.set());
    }
    return outcome;
}

}  // namespace hdconj::test
