// SPDX-License-Identifier: GPL-3.0-or-later
// The measured tooth as a scene.
#include <fmt/format.h>

#include <iterator>

#include "base/text.hpp"
#include "hdconj/error.hpp"
#include "hdconj/file/atomic_file.hpp"
#include "hdconj/inspect_files.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/scene/number_pairs.hpp"

namespace hdconj {
namespace {

namespace fs = std::filesystem;

/// The keys of the scene that change: the profile, and the file of a wave generator, whose name is relative to the
/// scene that was read.
std::vector<std::string> changes_of(Scene const& scene, fs::path const& points)
{
    std::vector<std::string> changes = {"!flexspline.profile", "flexspline.profile.family=\"points\"",
                                        "flexspline.profile.file=" + in_quotes(points.filename().string()),
                                        "flexspline.profile.side=\"right\""};
    auto const& shape = scene.wave_generator.shape;
    if (shape.has("file"))
        changes.push_back("wave_generator.file=" +
                          in_quotes(fs::absolute(scene::number_file(shape, "file", scene.folder)).string()));
    return changes;
}

}  // namespace

fs::path measured_tooth_points(fs::path const& scene_file)
{
    return scene_file.parent_path() / (scene_file.stem().string() + "-tooth.csv");
}

void write_measured_tooth(Inspection const& inspection, fs::path const& scene_file)
{
    if (inspection.mean_flank.empty())
        throw FileError(scene_file.string(), "the points give no mean tooth: no tooth has figures of both flanks");
    fs::path const points_file = measured_tooth_points(scene_file);
    std::string points = fmt::format(
        "# mean right flank of the teeth in {}, from tip to root, y from the pitch line\n# smoothed by degree 5 "
        "against arc length; the tooth is its mirror image\nx [mm],y [mm]\n",
        printable(inspection.file));
    for (Vec2 const& p : inspection.mean_flank)
        fmt::format_to(std::back_inserter(points), "{:.12f},{:.12f}\n", p.x(), p.y());
    file::write_text_atomically(points_file, points);
    auto const changed = examine_scene(inspection.scene.text, scene_file.string(), scene_file.parent_path(),
                                       changes_of(inspection.scene, points_file));
    file::write_text_atomically(scene_file, changed.scene.text);
}

}  // namespace hdconj
