// SPDX-License-Identifier: GPL-3.0-or-later
// All gaps of a surface before the circular spline is turned.
#pragma once

#include <memory>
#include <optional>

#include "contact/flank_grid.hpp"
#include "contact/gap_field.hpp"
#include "contact_context.hpp"

namespace hdconj::contact {

/// The map of gaps at rest, which assembly, the turn to first contact and the contact area all ask for.
class GapsAtRest
{
  public:
    /// GapField::map() of @p grid at turn 0. Kept for the next who asks for the same flanks at the same phase: of
    /// several phases for the first one.
    [[nodiscard]] std::shared_ptr<GapMap> operator()(ContactContext const& context, FlankGrid const& grid,
                                                     GapField const& field, double phase)
    {
        bool const same = kept_ && kept_->grid == grid;
        if (same && kept_->phase == phase)
            return kept_->map;
        auto map = std::make_shared<GapMap>(field.map(0, context.threads));
        if (!same)
            kept_ = Kept{grid, phase, map};
        return map;
    }

    void forget() { kept_.reset(); }

  private:
    struct Kept
    {
        FlankGrid grid;
        double phase;
        std::shared_ptr<GapMap> map;
    };
    std::optional<Kept> kept_;
};

}  // namespace hdconj::contact
