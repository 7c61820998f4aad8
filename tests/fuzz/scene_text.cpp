// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "hdconj/plan.hpp"
#include "hdconj/read_scene.hpp"
#include "refusal.hpp"
#include "targets.hpp"

namespace hdconj::fuzz {
namespace {

std::vector<std::string> lines_of(std::string_view text)
{
    std::vector<std::string> lines;
    while (!text.empty()) {
        std::size_t const end = text.find('\n');
        lines.emplace_back(text.substr(0, end));
        text = end == std::string_view::npos ? std::string_view{} : text.substr(end + 1);
    }
    return lines;
}

}  // namespace

void scene_text(Bytes input)
{
    std::string_view const all = text_of(input);
    std::size_t const end = all.find('\0');
    auto const overrides = end == std::string_view::npos ? std::vector<std::string>{} : lines_of(all.substr(end + 1));
    scene::SceneReading reading = examine_scene(all.substr(0, end), "fuzz.toml", {}, overrides);
    if (!accepted([&] { examine_geometry(reading); }))
        return;
    validate_faults(reading.faults);
    if (check_json("fuzz.toml", reading.faults, nullptr).empty())
        throw Find("faults without JSON");
    if (!reading.faults.empty())
        return;
    Plan const plan = make_plan(reading.scene);
    if (describe(plan).empty() || check_json("fuzz.toml", {}, &plan).empty())
        throw Find("a plan without words");
    // What --set leaves is written into results: it must be the same scene again.
    scene::SceneReading const again = examine_scene(reading.scene.text, "again.toml");
    if (!again.faults.empty())
        throw Find("the scene as recorded is refused: " + describe(again.faults));
    if (again.scene.drive.module != reading.scene.drive.module ||
        again.scene.solver.tolerance != reading.scene.solver.tolerance)
        throw Find("the scene as recorded is another one");
}

}  // namespace hdconj::fuzz
