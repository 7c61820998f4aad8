// SPDX-License-Identifier: GPL-3.0-or-later
// The measured tooth as a scene.
#include <fmt/format.h>

#include <algorithm>

#include "base/text.hpp"
#include "base/toml_string.hpp"
#include "hdconj/error.hpp"
#include "hdconj/file/atomic_file.hpp"
#include "hdconj/inspect_files.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/scene/number_pairs.hpp"

namespace hdconj {
namespace {

namespace fs = std::filesystem;

/// A key with its value.
std::string set(char const* key, double value)
{
    return fmt::format("{}={:.15g}", key, value);
}

/// By how much a tip clears the bottom of a measured tooth at least: what the scene's check asks for is more than 0.
double least_clearance(Scene const& scene)
{
    constexpr double in_modules = 1e-3;
    return in_modules * scene.drive.module;
}

/// Radius of the flexspline's pitch line at the major axis.
double pitch_line_radius(PairGeometry const& g)
{
    return g.r_m + g.w0 + g.pitch_line;
}

/// The flexspline's tooth was solved for: it is given now, and the circular spline's no longer, but its tip circle,
/// which clears the root of the measured tooth. The wall takes what the measured flank leaves of the dedendum, about
/// the same neutral layer.
void give_flexspline(Inspection const& inspection, std::vector<std::string>& changes)
{
    for (char const* key : {"!circular_spline.profile", "!flexspline.addendum", "!flexspline.dedendum"})
        changes.emplace_back(key);
    Flexspline const& ring = inspection.scene.flexspline;
    double const rest = inspection.geometry.dedendum + inspection.mean_flank.back().y();
    changes.push_back(set("flexspline.inner_radius", inspection.geometry.flexspline_inner_radius));
    changes.push_back(set("flexspline.wall", ring.wall + rest));
    changes.push_back(set("flexspline.neutral_offset", ring.neutral_offset + rest / 2));
    double const root = pitch_line_radius(inspection.geometry) + inspection.mean_flank.back().y();
    // the measured flank ends where the corner of the tip circle made it: there either may be longer by rounding
    changes.push_back(
        set("circular_spline.inner_radius",
            std::max(inspection.geometry.circular_spline_inner_radius, root) + least_clearance(inspection.scene)));
}

/// The circular spline's tooth was solved for: it is given now, with the side clearance that it was cut with, and the
/// flexspline's no longer, but its height, which clears the measured flank's end. Axial effects move a flexspline that
/// is given.
void give_circular_spline(Inspection const& inspection, std::vector<std::string>& changes)
{
    Scene const& scene = inspection.scene;
    changes.emplace_back("!flexspline.profile");
    for (char const* key :
         {"coning", "tilt", "slices", "contact", "circular_spline.backlash_offset", "circular_spline.root_clearance"})
        if (scene.given.contains(key))
            changes.push_back(std::string("!") + key);
    double const reach = -inspection.mean_flank.back().y() - least_clearance(scene);
    changes.push_back(set("flexspline.addendum", std::min(inspection.geometry.addendum, reach)));
    changes.push_back(set("flexspline.dedendum", inspection.geometry.dedendum));
}

char const* profile_key(Inspection const& inspection)
{
    return inspection.options.part == InspectedPart::circular_spline ? "circular_spline.profile" : "flexspline.profile";
}

/// The keys of the scene that change beside the new profile's own: what goes with it, and the file of a wave generator,
/// whose name is relative to the scene that was read.
std::vector<std::string> changes_of(Inspection const& inspection)
{
    Scene const& scene = inspection.scene;
    bool const spline = inspection.options.part == InspectedPart::circular_spline;
    std::string const profile = profile_key(inspection);
    std::vector<std::string> changes;
    if (spline)
        changes.push_back(set("circular_spline.inner_radius",
                              pitch_line_radius(inspection.geometry) - inspection.mean_flank.front().y()));
    if (scene.given.contains(profile))
        changes.push_back("!" + profile);
    else if (spline)
        give_circular_spline(inspection, changes);
    else
        give_flexspline(inspection, changes);
    changes.push_back(profile + ".side=\"right\"");
    auto const& shape = scene.wave_generator.shape;
    if (shape.has("file"))
        changes.push_back("wave_generator.file=" +
                          toml_string(fs::absolute(scene::number_file(shape, "file", scene.folder)).string()));
    return changes;
}

/// The scene with a profile of the family @p family, whose points are @p points, a key with its value.
scene::SceneReading with_profile(Inspection const& inspection, std::string const& family, std::string const& points,
                                 fs::path const& scene_file)
{
    std::vector<std::string> changes = changes_of(inspection);
    std::string const profile = profile_key(inspection);
    changes.push_back(profile + ".family=" + in_quotes(family));
    changes.push_back(profile + "." + points);
    return examine_scene(inspection.scene.text, scene_file.string(), scene_file.parent_path(), changes);
}

void require_mean_tooth(Inspection const& inspection, fs::path const& scene_file)
{
    if (inspection.mean_flank.empty())
        throw FileError(scene_file.string(), "the points give no mean tooth: no tooth has figures of both flanks");
}

/// A point with @p separator between its coordinates.
std::string point_text(Vec2 const& p, char const* separator)
{
    return fmt::format("{:.12f}{}{:.12f}", p.x(), separator, p.y());
}

}  // namespace

fs::path measured_tooth_points(fs::path const& scene_file)
{
    return scene_file.parent_path() / (scene_file.stem().string() + "-tooth.csv");
}

scene::SceneReading measured_tooth_scene(Inspection const& inspection, fs::path const& scene_file)
{
    require_mean_tooth(inspection, scene_file);
    std::string points = "points=[";
    for (Vec2 const& p : inspection.mean_flank)
        points += "[" + point_text(p, ", ") + "], ";
    return with_profile(inspection, "b-spline", points + "]", scene_file);
}

void write_measured_tooth(Inspection const& inspection, fs::path const& scene_file)
{
    require_mean_tooth(inspection, scene_file);
    fs::path const points_file = measured_tooth_points(scene_file);
    std::string points = fmt::format(
        "# mean right flank of the teeth in {}, from tip to root, y from the pitch line towards the tip\n# smoothed "
        "against arc length; the tooth is its mirror image\nx [mm],y [mm]\n",
        printable(inspection.file));
    for (Vec2 const& p : inspection.mean_flank)
        points += point_text(p, ",") + "\n";
    file::write_text_atomically(points_file, points);
    auto const changed =
        with_profile(inspection, "points", "file=" + toml_string(points_file.filename().string()), scene_file);
    file::write_text_atomically(scene_file, changed.scene.text);
}

}  // namespace hdconj
