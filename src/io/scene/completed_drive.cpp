// SPDX-License-Identifier: GPL-3.0-or-later
// A found neutral curve as files: the table of the cam, its surface, and the scene of the completed drive.
#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "base/text.hpp"
#include "base/toml_string.hpp"
#include "hdconj/file/atomic_file.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/scene/number_pairs.hpp"
#include "hdconj/units.hpp"
#include "hdconj/wanted_curve_files.hpp"

namespace hdconj {
namespace {

namespace fs = std::filesystem;

/// The keys of the scene that change. A file that the scene names is relative to the scene that was read.
std::vector<std::string> completing_changes(Scene const& scene, fs::path const& cam)
{
    std::vector<std::string> changes = {"!circular_spline.profile", "!wave_generator",
                                        "wave_generator.family=\"table\"",
                                        "wave_generator.file=" + toml_string(cam.filename().string()),
                                        "wave_generator.waves=" + std::to_string(scene.wave_generator.waves)};
    auto const& profile = scene.flexspline.profile;
    if (profile.has("file"))
        changes.push_back("flexspline.profile.file=" +
                          toml_string(fs::absolute(scene::number_file(profile, "file", scene.folder)).string()));
    return changes;
}

}  // namespace

void write_cam_table(WantedCurve const& found, fs::path const& file)
{
    std::string text = fmt::format(
        "# displacement of the neutral curve on which both teeth of {} touch, one wave\n"
        "angle_deg,radial_displacement_mm\n",
        printable(found.scene.drive.name));
    std::size_t const last = found.rows.size() - 1;
    for (std::size_t i = 0; i < 2 * last; ++i) {
        WantedCurveRow const& row = found.rows[i <= last ? i : 2 * last - i];
        double const wave = 360.0 / found.scene.wave_generator.waves;
        double const degrees = wave * static_cast<double>(i) / (2 * static_cast<double>(last));
        fmt::format_to(std::back_inserter(text), "{:.15g},{:.17g}\n", degrees, row.displacement);
    }
    file::write_text_atomically(file, text);
}

void write_inner_surface(WantedCurve const& found, fs::path const& file)
{
    std::string text = fmt::format(
        "# surface of the cam, {:.6g} mm inside the neutral curve of {}; angles clockwise "
        "from the major axis\nangle_deg,radius_mm,x_mm,y_mm\n",
        found.inner_distance, printable(found.scene.drive.name));
    for (Vec2 const& p : found.inner_surface)
        fmt::format_to(std::back_inserter(text), "{:.12f},{:.12f},{:.12f},{:.12f}\n", to_deg(std::atan2(p.x(), p.y())),
                       p.norm(), p.x(), p.y());
    file::write_text_atomically(file, text);
}

fs::path completed_drive_cam(fs::path const& scene_file)
{
    return scene_file.parent_path() / (scene_file.stem().string() + "-cam.csv");
}

void write_completed_drive(WantedCurve const& found, fs::path const& scene_file)
{
    fs::path const cam = completed_drive_cam(scene_file);
    write_cam_table(found, cam);
    auto const changed = examine_scene(found.scene.text, scene_file.string(), scene_file.parent_path(),
                                       completing_changes(found.scene, cam));
    file::write_text_atomically(scene_file, changed.scene.text);
}

}  // namespace hdconj
