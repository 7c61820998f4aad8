// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/option_faults.hpp"
#include "base/text.hpp"
#include "hdconj/contact.hpp"
#include "hdconj/scene/schema.hpp"
#include "hdconj/units.hpp"
#include "scene/usual_cup.hpp"
#include "surface_choices.hpp"

namespace hdconj {

Faults check_options(ContactOptions const& options)
{
    Faults faults;
    double const steepest = scene::bounds::largest_tilt_deg * deg;
    std::vector<double> tilts = options.tilts;
    for (double const end : {options.best_from, options.best_to})
        if (options.best && std::ranges::find(tilts, end) == tilts.end())
            tilts.push_back(end);
    for (double const tilt : tilts) {
        if (!std::isfinite(tilt))
            faults.push_back(
                {"--tilt", 0, short_number(tilt), "not a finite number", "write angles in degrees such as 0,0.1,0.2"});
        else if (!(std::abs(tilt) < steepest))
            faults.push_back({"--tilt", 0, short_number(tilt / deg), "teeth are not tilted by 45 degrees or more",
                              "write angles in degrees such as 0,0.1,0.2"});
    }
    if (options.revolution != 0)
        require_whole(faults, "--revolution", options.revolution, 1, scene::bounds::most_revolution_angles,
                      "one such as 24, or leave it out for the scene's angle only");
    return faults;
}

Faults check_contact(Scene const& scene, ContactOptions const& options)
{
    Faults faults;
    if (scene.is_reverse())
        faults.push_back({"circular_spline.profile", scene.circular_spline.profile->line, "",
                          "contact needs the flexspline's tooth, but the circular spline's is given",
                          "give [flexspline.profile]; `hdconj solve` finds the tooth that this circular spline needs"});
    if (!scene.circular_spline.width)
        faults.push_back({"circular_spline.width", 0, "",
                          "this key is missing: contact is an area, and needs the face width",
                          "write width = " + scene::length_text(scene::UsualCup(scene).spline_width) +
                              ", a length in mm, in [circular_spline]"});
    for (Fault& fault : check_options(options))
        faults.push_back(std::move(fault));
    std::vector<ToothSurface> const surfaces =
        contact::or_else(options.surfaces, scene.slices ? scene.slices->surface : ToothSurface::tilted);
    std::vector<TiltKind> const kinds =
        contact::or_else(options.kinds, scene.tilt ? scene.tilt->kind : TiltKind::radial);
    bool const draft = std::find(kinds.begin(), kinds.end(), TiltKind::draft) != kinds.end();
    bool const tilted = std::find(surfaces.begin(), surfaces.end(), ToothSurface::tilted) != surfaces.end();
    std::string const first(to_string(surfaces.front()));
    if (draft && !tilted) {
        bool const by_kind = !options.kinds.empty();
        faults.push_back(
            {by_kind ? "--kind" : "--surface", 0, by_kind ? "draft" : first,
             "a draft needs one outline to offset, but surface \"" + first + "\" has an outline for each slice",
             "write --kind radial, or --surface tilted"});
    }
    if (options.best && !tilted)
        faults.push_back(
            {"--best", 0, "",
             "the search is for the tilt of surface \"tilted\", but surface \"" + first + "\" is asked for",
             "write --surface tilted, or list tilts with --tilt"});
    if (options.best && !(options.best_to > options.best_from))
        faults.push_back(
            {"--best", 0, "", "the interval of tilts to search is empty", "write --tilt FROM,TO with FROM below TO"});
    return faults;
}

}  // namespace hdconj
