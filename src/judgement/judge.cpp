// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/judgement.hpp"

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "checks.hpp"
#include "drive/drive.hpp"

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

Notes notes_on(UnsolvedPair const& pair)
{
    return all_of({deformation(pair), tooth_difference(pair), tip_land(pair), wall_stress(pair), late_mesh(pair)});
}

Notes notes_on(Solution const& solution)
{
    return all_of(
        {flank_contact(solution), land(solution), undercut(solution), sharp_corner(solution), narrow_space(solution)});
}

void judge_late_mesh_again(Notes& notes, Scene const& scene)
{
    auto const is_late_mesh = [](Note const& note) { return note.code == NoteCode::late_mesh; };
    std::erase_if(notes, is_late_mesh);
    std::ranges::copy_if(judge(scene), std::back_inserter(notes), is_late_mesh);
    std::ranges::stable_sort(notes, {}, &Note::code);
}

void raise_tip_circle(std::vector<std::string> const& wanted, std::string& words, std::vector<std::string>& set)
{
    constexpr std::string_view key = "circular_spline.inner_radius=";
    auto const writes_it = [&](std::string const& setting) { return setting.starts_with(key); };
    auto const from = std::ranges::find_if(wanted, writes_it);
    auto const to = std::ranges::find_if(set, writes_it);
    if (from == wanted.end() || to == set.end())
        return;
    std::string const value = from->substr(key.size()), smaller = to->substr(key.size());
    if (!(std::stod(value) > std::stod(smaller)))
        return;
    if (auto const at = words.find(smaller); at != std::string::npos)
        words.replace(at, smaller.size(), value);
    *to = *from;
}

void agree_on_tip_circle(Notes& notes)
{
    for (Note& note : notes)
        for (Note const& other : notes)
            raise_tip_circle(other.set, note.advice, note.set);
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
