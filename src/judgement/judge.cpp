// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/judgement.hpp"

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/text.hpp"
#include "checks.hpp"
#include "drive/drive.hpp"
#include "scene/usual_drive.hpp"

namespace hdconj::judgement {
namespace {

Notes all_of(std::initializer_list<std::optional<Note>> checks)
{
    Notes notes;
    for (auto const& check : checks)
        if (check)
            notes.push_back(*check);
    return notes;
}

}  // namespace

std::optional<std::string> value_in(std::vector<std::string> const& set, std::string const& key)
{
    for (std::string const& each : set)
        if (auto const at = each.find(key); at != std::string::npos)
            return each.substr(at + key.size());
    return std::nullopt;
}

void rewrite_value(std::string const& key, std::string const& value, std::string& words, std::vector<std::string>& set)
{
    for (std::string& each : set) {
        auto const at = each.find(key);
        if (at == std::string::npos)
            continue;
        std::string const before = each.substr(at + key.size());
        if (auto const told = words.find(before); told != std::string::npos)
            words.replace(told, before.size(), value);
        each.replace(at + key.size(), before.size(), value);
    }
}

Notes notes_on(UnsolvedPair const& pair)
{
    return all_of({deformation(pair), tooth_difference(pair), tip_land(pair), wall_stress(pair), late_mesh(pair)});
}

Notes notes_on(Solution const& solution)
{
    return all_of(
        {flank_contact(solution), land(solution), undercut(solution), narrow_space(solution.scene, solution)});
}

void replace_note(Notes& notes, NoteCode code, std::optional<Note> const& note)
{
    std::erase_if(notes, [&](Note const& each) { return each.code == code; });
    if (note)
        notes.push_back(*note);
    std::ranges::stable_sort(notes, {}, &Note::code);
}

void judge_late_mesh_again(Notes& notes, Scene const& scene)
{
    Notes const all = judge(scene);
    auto const found = std::ranges::find(all, NoteCode::late_mesh, &Note::code);
    replace_note(notes, NoteCode::late_mesh, found == all.end() ? std::nullopt : std::optional(*found));
}

void judge_narrow_space_again(Notes& notes, Scene const& scene, Solution const& solution)
{
    replace_note(notes, NoteCode::narrow_space, narrow_space(scene, solution));
}

void raise_tip_circle(UnsolvedPair const& pair, std::vector<std::string> const& wanted, std::string& words,
                      std::vector<std::string>& set)
{
    auto const from = value_in(wanted, tip_circle_key), to = value_in(set, tip_circle_key),
               before = value_in(wanted, deformation_key), after = value_in(set, deformation_key);
    if (!from || !to || (before && !after))
        return;
    std::string value = *from;
    if (after && !before) {
        auto const usual = scene::usual_tip_radius(pair.scene, pair.geometry.w0),
                   usual_then = scene::usual_tip_radius(pair.scene, std::stod(*after));
        if (!usual || !usual_then)
            return;
        constexpr int digits = 6;
        value = short_number(std::stod(value) + *usual_then - *usual, digits);
    }
    if (!(std::stod(value) > std::stod(*to)))
        return;
    rewrite_value(tip_circle_key, value, words, set);
}

void agree_on_tip_circle(UnsolvedPair const& pair, Notes& notes)
{
    for (Note& note : notes)
        for (Note const& other : notes)
            raise_tip_circle(pair, other.set, note.advice, note.set);
}

}  // namespace hdconj::judgement

namespace hdconj {

Notes judge(Scene const& scene)
{
    Faults faults;
    profile::Profile const tooth = drive::given_tooth(scene, faults);
    wavegen::AnyWaveShape const shape = drive::wave_shape(scene, tooth, faults);
    if (!faults.empty())
        return {};
    return judgement::notes_on({scene, drive::pair_geometry(scene, tooth, shape.amplitude()), tooth, shape});
}

}  // namespace hdconj
