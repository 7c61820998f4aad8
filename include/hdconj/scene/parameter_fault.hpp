// SPDX-License-Identifier: GPL-3.0-or-later
// The fault of one parameter of a family, with its place in the scene.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include "hdconj/error.hpp"
#include "hdconj/scene/parameters.hpp"

namespace hdconj::scene {

/// What is wrong with the key @p key of @p choice: path, line and value as given, and the reason and remedy.
[[nodiscard]] Fault parameter_fault(FamilyChoice const& choice, std::string_view key, std::string reason,
                                    std::string remedy);

/// Collects the faults of one family's parameters.
class ParameterFaults
{
  public:
    ParameterFaults(FamilyChoice const& choice, Faults& faults)
        : choice_(choice), faults_(faults), before_(faults.size())
    {
    }

    /// Adds the fault of the key @p key.
    /// @param value  that the remedy names; empty where it names none
    void operator()(std::string_view key, std::string reason, std::string remedy, std::string const& value = {}) const
    {
        faults_.push_back(parameter_fault(choice_, key, std::move(reason), std::move(remedy)));
        if (!value.empty())
            faults_.back().set = {faults_.back().path + "=" + value};
    }

    /// Whether the list has grown since this object was made.
    [[nodiscard]] bool any() const { return faults_.size() > before_; }

  private:
    FamilyChoice const& choice_;
    Faults& faults_;
    std::size_t before_;
};

}  // namespace hdconj::scene
