// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Which surfaces scene and options ask for.
#pragma once

#include <string>
#include <vector>

#include "hdconj/pipeline/contact.hpp"
#include "hdconj/profile/builder.hpp"
#include "hdconj/scene/schema.hpp"
#include "spline_surface.hpp"

namespace hdconj::detail {

[[nodiscard]] inline std::vector<std::string> or_else(std::vector<std::string> const& asked, std::string const& otherwise)
{
    return asked.empty() ? std::vector<std::string>{otherwise} : asked;
}

/// Every combination that makes a difference, in the order asked for.
[[nodiscard]] inline std::vector<SurfaceChoice> surface_choices(Scene const& scene, ContactOptions const& options)
{
    std::vector<double> const tilts = options.tilts.empty() ? std::vector<double>{scene.tilt ? scene.tilt->angle : 0.0} : options.tilts;
    std::vector<SurfaceChoice> result;
    for (std::string const& surface : or_else(options.surfaces, scene.slices ? scene.slices->surface : "tilted"))
        for (std::string const& kind : or_else(options.kinds, scene.tilt ? scene.tilt->kind : "radial"))
            for (double const tilt : tilts)
                if (surface == "tilted" || kind == "radial" || tilt == 0)
                    result.push_back({surface, kind, tilt});
    return result;
}

/// Why one of them is not there.
[[nodiscard]] inline std::string no_row(SurfaceChoice const& choice, std::string const& why)
{
    return "no row for a tilt of " + short_number(choice.tilt / rad_per_deg) + " deg, " + choice.kind + ", surface \"" + choice.surface + "\": " + why;
}

}  // namespace hdconj::detail
