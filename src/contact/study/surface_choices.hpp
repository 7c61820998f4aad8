// SPDX-License-Identifier: GPL-3.0-or-later
// Which surfaces scene and options ask for.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "base/text.hpp"
#include "hdconj/contact.hpp"
#include "hdconj/scene/schema.hpp"
#include "hdconj/units.hpp"
#include "surface/tooth_surface.hpp"

namespace hdconj::contact {

template <class Value>
[[nodiscard]] std::vector<Value> or_else(std::vector<Value> const& asked, Value otherwise)
{
    return asked.empty() ? std::vector<Value>{otherwise} : asked;
}

/// Every combination that there is, in the order asked for: a draft offsets one outline, and surfaces with an outline
/// for each slice have none.
[[nodiscard]] inline std::vector<surface::SurfaceSpec> surface_choices(Scene const& scene,
                                                                       ContactOptions const& options)
{
    std::vector<double> const tilts =
        options.tilts.empty() ? std::vector<double>{scene.tilt ? scene.tilt->angle : 0.0} : options.tilts;
    std::vector<surface::SurfaceSpec> result;
    for (ToothSurface const surface :
         or_else(options.surfaces, scene.slices ? scene.slices->surface : ToothSurface::tilted))
        for (TiltKind const kind : or_else(options.kinds, scene.tilt ? scene.tilt->kind : TiltKind::radial))
            for (double const tilt : tilts)
                if (surface == ToothSurface::tilted || kind == TiltKind::radial)
                    result.push_back({surface, kind, tilt});
    return result;
}

[[nodiscard]] inline std::string spec_words(surface::SurfaceSpec const& spec)
{
    return fmt::format("tilt {} deg, kind \"{}\", surface \"{}\"", short_number(spec.tilt / deg), to_string(spec.kind),
                       to_string(spec.surface));
}

/// What is asked for and is no surface: for users.
[[nodiscard]] inline std::vector<std::string> impossible_choices(ContactOptions const& options)
{
    std::vector<std::string> result;
    if (std::ranges::find(options.kinds, TiltKind::draft) != options.kinds.end())
        for (ToothSurface const surface : options.surfaces)
            if (surface != ToothSurface::tilted)
                result.push_back(
                    fmt::format("no result for kind \"draft\", surface \"{}\": a draft needs one outline "
                                "to offset, and this surface has one for each slice",
                                to_string(surface)));
    return result;
}

/// Why one of them is not there.
[[nodiscard]] inline std::string no_row(surface::SurfaceSpec const& spec, std::string const& why)
{
    return fmt::format("no result for {}: {}", spec_words(spec), why);
}

/// Whether scene or options ask for an effect along the axis.
[[nodiscard]] inline bool is_axial(Scene const& scene, ContactOptions const& options)
{
    return scene.coning || scene.tilt || scene.slices || !options.tilts.empty() || !options.surfaces.empty() ||
           options.best;
}

}  // namespace hdconj::contact
