// SPDX-License-Identifier: GPL-3.0-or-later
#include "stored_group.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <memory>
#include <sstream>
#include <utility>

#include "hdconj/error.hpp"
#include "hdconj/read_scene.hpp"
#include "results.hpp"

namespace hdconj::io::layout {
namespace {

/// Lengths of the dimensions of a group and of those around it.
using Sizes = std::map<std::string, std::size_t>;

void read_dataset(StoredGroup const& place, RecordedDataset const& set, GroupSink& into, Sizes& sizes)
{
    StoredValues const stored = place.dataset(set.name, set.kind, set.rank);
    Shape const& shape = stored.shape;
    for (std::size_t i = 0; i < set.rank; ++i) {
        bool const own_scale = set.rank == 1 && set.name == set.about.dims.front();
        auto const [known, is_new] = sizes.emplace(set.about.dims[i], shape[i]);
        if (own_scale)
            known->second = shape[i];
        else if (!is_new && known->second != shape[i])
            throw Misfit(fmt::format("{} has {} along {}, and others have {}", set.name, shape[i], set.about.dims[i],
                                     known->second));
    }
    std::visit([&](auto const& values) { into.dataset(set.name, shape, values.data(), set.about); }, stored.values);
}

void read_group(StoredGroup const& place, RecordedGroup const& pattern, GroupSink& into, Sizes sizes)
{
    for (auto const& each : pattern.attributes)
        if (place.has_attribute(each.first))
            into.attribute(each.first, place.attribute(each.first, each.second));
    for (auto const& set : pattern.datasets)
        if (place.holds(set.name))
            read_dataset(place, set, into, sizes);
    for (auto const& figure : pattern.figures)
        into.figure(figure);
    auto const enter = [&](std::string const& name, RecordedGroup const& inner) {
        into.group(name, [&](GroupSink& made) { read_group(*place.group(name), inner, made, sizes); });
    };
    for (auto const& inner : pattern.groups) {
        std::string_view const name = inner.name, first = "_000";
        if (!name.ends_with(first)) {
            if (place.holds(inner.name))
                enter(inner.name, inner);
            continue;
        }
        std::string_view const stem = name.substr(0, name.size() - first.size());
        for (int i = 0; place.holds(fmt::format("{}_{:03}", stem, i)); ++i)
            enter(fmt::format("{}_{:03}", stem, i), inner);
    }
}

std::vector<OutlinePiece> pieces_of(StoredGroup const& place, std::size_t points)
{
    auto const kinds = place.list<std::string>("kind"), segments = place.list<std::string>("segment_name");
    auto const first = place.list<int>("first"), last = place.list<int>("last");
    require(segments.size() == kinds.size() && first.size() == kinds.size() && last.size() == kinds.size(),
            "lists of pieces differ in length");
    std::vector<OutlinePiece> pieces;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        require(first[i] >= 0 && last[i] >= first[i] && static_cast<std::size_t>(last[i]) < points,
                "a piece lies outside the outline");
        pieces.push_back(
            {kinds[i], segments[i], static_cast<std::size_t>(first[i]), static_cast<std::size_t>(last[i])});
    }
    return pieces;
}

CircularSplineOutline outline_of(StoredGroup const& place)
{
    constexpr std::size_t slices_points_coordinates = 3, plane = 2;
    CircularSplineOutline result;
    result.z = place.list<double>("z");
    StoredValues const outline = place.dataset("outline", 0, slices_points_coordinates);
    auto const& flat = std::get<std::vector<double>>(outline.values);
    std::size_t const slices = outline.shape[0], points = outline.shape[1];
    require(outline.shape[2] == plane && slices == result.z.size() && slices > 0 && points > 0,
            "outline and z do not go together");
    for (double const value : flat)
        require(std::isfinite(value), "a point of the outline is not finite");
    for (std::size_t k = 0; k < slices; ++k) {
        auto& slice = result.outline.emplace_back();
        for (std::size_t i = 0; i < points; ++i) {
            std::size_t const at = plane * (k * points + i);
            slice.emplace_back(flat[at], flat[at + 1]);
        }
    }
    result.landmarks = place.list<int>("landmarks");
    for (int const landmark : result.landmarks)
        require(landmark >= 0 && static_cast<std::size_t>(landmark) < points, "a landmark lies outside the outline");
    result.pieces = pieces_of(*place.group("pieces"), points);
    return result;
}

/// The table that write_notes() writes, where the root @p result has it.
Notes judgement_of(StoredGroup const& result)
{
    if (!result.holds("notes"))
        return {};
    auto const place = result.group("notes");
    auto const words = [&](char const* name) { return place->list<std::string>(name); };
    auto const code = words("code"), severity = words("severity"), unit = words("unit"), where = words("place"),
               cause = words("cause"), advice = words("advice"), set = words("set");
    auto const figure = place->list<double>("figure"), limit = place->list<double>("limit");
    for (auto const* const each : {&severity, &unit, &where, &cause, &advice, &set})
        require(each->size() == code.size(), "lists of notes differ in length");
    require(figure.size() == code.size() && limit.size() == code.size(), "lists of notes differ in length");
    Notes notes;
    for (std::size_t i = 0; i < code.size(); ++i) {
        auto const known = from_word<NoteCode>(code[i]);
        auto const grave = from_word<Severity>(severity[i]);
        require(known && grave, "a note has an unknown code or severity");
        std::istringstream keys(set[i]);
        notes.push_back({*known,
                         *grave,
                         figure[i],
                         limit[i],
                         unit[i],
                         where[i],
                         cause[i],
                         advice[i],
                         {std::istream_iterator<std::string>(keys), {}}});
    }
    return notes;
}

/// What the root @p result, of the format @p version, holds of the solution but for its scene. Older formats may lack
/// a figure.
Solution solution_of(StoredGroup const& result, int version)
{
    Solution solution;
    auto const summary = result.group("summary");
    for (auto const& [name, value] : {std::pair("tip_radius_mm", &solution.geometry.circular_spline_inner_radius),
                                      {"error_chord_mm", &solution.error.chord},
                                      {"error_point_mm", &solution.error.point},
                                      {"error_side_clearance_mm", &solution.error.side_clearance},
                                      {"error_cup_mm", &solution.error.cup}})
        if (version == format_version || summary->has_attribute(name))
            *value = summary->attribute<double>(name);
    if (result.has_attribute("notes"))
        solution.notes = result.attribute<std::vector<std::string>>("notes");
    solution.judgement = judgement_of(result);
    return solution;
}

/// The cases of the group @p place of contact or load; none in a file of the first format.
std::vector<StoredCase> cases_of(StoredGroup const& place)
{
    std::vector<StoredCase> cases;
    if (!place.holds("side_clearance_increased"))
        return cases;
    auto const surface = place.list<std::string>("surface"), kind = place.list<std::string>("kind");
    auto const increased = place.list<int>("side_clearance_increased");
    auto const column = [&](char const* name) {
        return place.holds(name) ? place.list<double>(name) : std::vector<double>();
    };
    auto const tilt = column("tilt"), offset = column("backlash_offset"), tip = column("tip_radius"),
               least = column("least_side_clearance"), least_tip = column("least_tip_radius"),
               flank = column("flank_clearance"), error = column("flank_clearance_error"), z = column("flank_z");
    std::size_t const count = surface.size();
    require(kind.size() == count, "lists of cases differ in length");
    for (auto const* const each : {&tilt, &offset, &tip})
        require(each->size() == count && increased.size() == count, "lists of cases differ in length");
    bool const has_flank =
        flank.size() == count && z.size() == count && least.size() == count && least_tip.size() == count;
    constexpr double touches = 1e-6;  // of teeth that shall touch, without an error [mm]
    for (std::size_t i = 0; i < count; ++i) {
        StoredCase one{surface[i], kind[i], tilt[i], {}, 0, increased[i] != 0, offset[i], tip[i]};
        if (has_flank) {
            one.flank_clearance = flank[i];
            one.flank_z = z[i];
            one.interferes = one.interferes || flank[i] < -std::max(touches, error.size() == count ? error[i] : 0);
            one.side_clearance = std::max(offset[i], least[i]);
            one.tip_radius = std::max(tip[i], least_tip[i]);
        }
        cases.push_back(std::move(one));
    }
    return cases;
}

}  // namespace

void read_layout(StoredGroup const& place, RecordedGroup const& pattern, GroupSink& into)
{
    read_group(place, pattern, into, {});
}

scene::NamedTexts files_of(StoredGroup const& result)
{
    scene::NamedTexts files;
    if (!result.holds("scene_files"))
        return files;
    auto const place = result.group("scene_files");
    auto const names = place->list<std::string>("name"), texts = place->list<std::string>("text");
    require(names.size() == texts.size(), "lists of files differ in length");
    for (std::size_t i = 0; i < names.size(); ++i)
        files.emplace(names[i], std::make_shared<std::string const>(texts[i]));
    return files;
}

StoredOutline stored_outline(StoredGroup const& result)
{
    auto const format = result.attribute<std::string>("format");
    require(
        format != "hdconj-neutral-curve",
        "it holds the neutral curve of a wanted scene; take the drive that hdconj solve --completed DRIVE.toml writes");
    require(format != "hdconj-inspection",
            "it holds the inspection of a part; take the file that solve, contact, load or "
            "run wrote of the drive");
    require(format == "hdconj", "it is of another program");
    int const version = result.attribute<int>("format_version");
    require(version <= format_version, "it was written by a newer version");
    auto const spline = result.group("circular_spline");
    StoredOutline stored{
        result.attribute<std::string>("scene"), solution_of(result, version), {}, {}, {}, files_of(result)};
    stored.solution.circular_spline = outline_of(*spline);
    for (auto const& [group, verb] : {std::pair("contact", "contact"), {"load", "load"}, {"running", "run"}})
        if (result.holds(group))
            stored.verb = verb;
    if (stored.verb == "contact" || stored.verb == "load")
        stored.cases = cases_of(*result.group(stored.verb));
    if (spline->has_attribute("side_clearance_mm"))
        stored.side_clearance = spline->attribute<double>("side_clearance_mm");
    return stored;
}

}  // namespace hdconj::io::layout

namespace hdconj {

scene::SceneReading examine_stored_scene(StoredOutline const& stored, std::filesystem::path const& file,
                                         std::vector<std::string> const& overrides)
{
    scene::SceneReading reading =
        examine_scene(stored.scene, file.string(), file.parent_path(), overrides, stored.files);
    Faults missing;
    for (auto const& [name, text] : reading.scene.files)
        if (text == nullptr)
            missing.push_back({file.string(), 0, "",
                               "its scene reads " + name + ", which is neither kept in the result nor beside it",
                               "put the file there, or solve the scene anew"});
    if (!missing.empty())
        throw InputError(std::move(missing));
    examine_geometry(reading);
    return reading;
}

}  // namespace hdconj
