// SPDX-License-Identifier: GPL-3.0-or-later
// The layouts of the result file, and of the file of a neutral curve that was wanted, as docs/reference/hdf5.md
// describes it.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <ctime>

#include "columns.hpp"
#include "figures/summary_figures.hpp"
#include "figures/wanted_figures.hpp"
#include "hdconj/version.hpp"
#include "results.hpp"

namespace hdconj::io {

std::string layout::date_text()
{
    char const* const given = std::getenv("SOURCE_DATE_EPOCH");
    std::time_t const seconds =
        given != nullptr ? static_cast<std::time_t>(std::strtoll(given, nullptr, 10)) : std::time(nullptr);
    std::tm fields = {};
    gmtime_r(&seconds, &fields);
    std::array<char, sizeof "-2147483648-12-31T23:59:59Z"> text = {};
    std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &fields);
    return text.data();
}

void layout::write_origin(Writer const& root, char const* format, int version, Scene const& scene)
{
    root.attribute("format", std::string(format));
    root.attribute("format_version", version);
    root.attribute("program_version", std::string(program_version()));
    root.attribute("git_revision", std::string(git_revision()));
    root.attribute("build", std::string(build_description()));
    root.attribute("date", date_text());
    root.attribute("drive", scene.drive.name);
}

void layout::write_scene(Writer const& root, Scene const& scene)
{
    root.attribute("scene", scene.text);
    std::vector<std::string> names, texts;
    for (auto const& [name, text] : scene.files)
        if (text != nullptr) {
            names.push_back(name);
            texts.push_back(*text);
            std::ranges::replace(texts.back(), '\0', ' ');  // would end the text in the file; no number has it
        }
    if (names.empty())
        return;
    root.group("scene_files", [&](Writer const& place) {
        place.texts("name", names, "file that the scene names", "file");
        place.texts("text", texts, "what the file held", "file");
    });
}

namespace {

using layout::column;
using layout::Owner;
using layout::Writer;

void write_provenance(Writer const& root, Solution const& solution)
{
    layout::write_origin(root, "hdconj", layout::format_version, solution.scene);
    root.attribute("given", figures::given_member(solution));
    layout::write_scene(root, solution.scene);
    root.attribute("threads", solution.threads);
    root.attribute("plan", describe(solution.plan));
    root.attribute("stages", column(solution.plan.stages,
                                    [](auto const& planned) -> std::string { return to_string(planned.stage); }));
    if (!solution.notes.empty())
        root.attribute("notes", solution.notes);
    root.flag("certified", solution.certificate.certified());
}

void write_branch(Writer const& branch, BranchRecord const& record, bool reverse)
{
    branch.attribute("kind", record.kind);
    branch.attribute("segment", record.segment);
    branch.attribute("segment_name", record.segment_name);
    branch.attribute("begins", record.begins);
    branch.attribute("ends", record.ends);
    branch.flag("on_boundary", record.on_boundary);
    if (reverse)
        branch.attribute("tooth", record.tooth);
    branch.numbers("u", record.u,
                   {"rad", "polar angle of the tooth on the deformed neutral curve", {"u"}, Owner::result});
    branch.numbers("phi", record.phi, {"rad", "angle of the tooth on the undeformed ring", {"u"}, Owner::result});
    branch.numbers("t", record.t, {"1", "profile parameter, 0 to 1 along the segment", {"u"}, Owner::result});
    branch.points(
        "point", record.point,
        reverse ? "contact, in the frame of the flexspline tooth" : "contact, in the frame of the circular spline", "u",
        Owner::result);
}

void write_envelope(Writer const& root, Solution const& solution)
{
    root.group("envelope", [&](Writer const& envelope) {
        bool const reverse = solution.scene.is_reverse();
        envelope.attribute("segments", solution.segment_names);
        envelope.attribute("frame", std::string(reverse ? "flexspline tooth" : "circular spline"));
        envelope.groups("branch", solution.branches, [&](Writer const& branch, BranchRecord const& record) {
            write_branch(branch, record, reverse);
        });
    });
}

void write_intervals(Writer const& place, std::string const& name, std::vector<ConjugateZone> const& zones,
                     double ConjugateZone::*begin, double ConjugateZone::*end, char const* units, char const* meaning)
{
    std::vector<double> pairs;
    for (auto const& zone : zones)
        pairs.insert(pairs.end(), {zone.*begin, zone.*end});
    place.array(name, {zones.size(), 2}, pairs.data(), {units, meaning, {"zone", "end"}});
}

void write_zones(Writer const& root, std::vector<ConjugateZone> const& zones)
{
    root.group("conjugate_zones", [&](Writer const& place) {
        place.integers("branch", column(zones, [](auto const& zone) { return static_cast<int>(zone.branch); }),
                       {"1", "number of the branch", {"zone"}});
        place.integers("segment", column(zones, &ConjugateZone::segment), {"1", "number in segments", {"zone"}});
        layout::write_columns(place, "zone", figures::zone_figures(), zones);
        write_intervals(place, "u", zones, &ConjugateZone::u_begin, &ConjugateZone::u_end, "rad",
                        "polar angle of the tooth at begin and end");
        write_intervals(place, "phi", zones, &ConjugateZone::phi_begin, &ConjugateZone::phi_end, "rad",
                        "undeformed angle of the tooth at begin and end");
        write_intervals(place, "t", zones, &ConjugateZone::t_begin, &ConjugateZone::t_end, "1",
                        "profile parameter at begin and end");
    });
}

/// The places that keep a result from being certified; empty where it is.
void write_certificate(Writer const& root, std::vector<UndecidedPlace> const& places)
{
    root.group("undecided", [&](Writer const& place) {
        place.texts("what", column(places, &UndecidedPlace::what), "what happens there", "place");
        place.texts("segment_name", column(places, &UndecidedPlace::segment_name), "segment of the profile", "place");
        layout::write_columns(place, "place", figures::undecided_figures(), places);
    });
}

void write_pieces(Writer const& member, std::vector<OutlinePiece> const& pieces)
{
    member.group("pieces", [&](Writer const& place) {
        place.texts("kind", column(pieces, &OutlinePiece::kind), "kind of the piece", "piece");
        place.texts("segment_name", column(pieces, &OutlinePiece::segment_name), "segment that made it, or empty",
                    "piece");
        place.integers("first", column(pieces, [](auto const& piece) { return static_cast<int>(piece.first); }),
                       {"1", "first point of the piece", {"piece"}});
        place.integers("last", column(pieces, [](auto const& piece) { return static_cast<int>(piece.last); }),
                       {"1", "last point of the piece", {"piece"}});
    });
}

/// Names and units are those of JSON.
void write_summary(Writer const& root, Solution const& solution)
{
    auto const write = [&](Writer const& summary, figures::Rows<Solution> const& rows) {
        for (auto const& figure : rows) {
            bool const estimated = figure.error != nullptr;
            summary.attribute(figure.json_key(), figure.unit.shown(figure.value(solution)));
            if (estimated)
                summary.attribute(figure.json_key_of_error(), figure.unit.shown_error(figure.error(solution)));
            summary.figure({figure.key_stem(), figure.json_key(), estimated ? figure.json_key_of_error() : "",
                            figure.unit.text, figure.meaning, true});
        }
    };
    root.group("summary", [&](Writer const& summary) {
        write(summary, figures::geometry_figures());
        if (solution.check)
            write(summary, figures::clearance_figures());
        write(summary, figures::error_figures());
    });
}

/// Nothing where there are none.
void write_notes(Writer const& root, Notes const& notes)
{
    if (notes.empty())
        return;
    root.group("notes", [&](Writer const& place) {
        auto const words = [&](char const* name, char const* meaning, auto take) {
            place.texts(name, column(notes, take), meaning, "note");
        };
        words("code", "what is judged", [](Note const& note) { return std::string(to_string(note.code)); });
        words("severity", "information or warning",
              [](Note const& note) { return std::string(to_string(note.severity)); });
        place.numbers("figure", column(notes, &Note::figure), {"1", "figure of the design, in its own unit", {"note"}});
        place.numbers("limit", column(notes, &Note::limit), {"1", "limit that it leaves, in the same unit", {"note"}});
        words("unit", "unit of figure and limit", [](Note const& note) { return note.unit; });
        words("place", "where, or which key", [](Note const& note) { return note.place; });
        words("cause", "what is wrong", [](Note const& note) { return note.cause; });
        words("advice", "what to write instead", [](Note const& note) { return note.advice; });
        words("set", "the advice as arguments of --set",
              [](Note const& note) { return fmt::format("{}", fmt::join(note.set, " ")); });
    });
}

void write_timing(Writer const& root, std::vector<StageTime> const& timing)
{
    root.group("timing", [&](Writer const& place) {
        place.texts("stage", column(timing, &StageTime::stage), "name of the stage", "stage");
        place.numbers("seconds", column(timing, &StageTime::seconds), {"s", "time of the stage", {"stage"}});
    });
}

}  // namespace

void layout::write_solution(layout::Writer const& root, Solution const& solution)
{
    write_provenance(root, solution);
    root.texts("xy", {"x", "y"}, "coordinate of a point", "xy");
    root.texts("end", {"begin", "end"}, "end of an interval", "end");
    root.group("flexspline", [&](layout::Writer const& place) {
        place.points("outline", solution.flexspline_outline, "one tooth, left to right, y from the pitch line", "point",
                     Owner::result);
        if (solution.scene.is_reverse())
            write_pieces(place, solution.flexspline_pieces);
    });
    root.points("neutral_curve", solution.neutral_curve, "deformed neutral curve in the fixed frame, closed",
                "neutral_point", Owner::result);
    write_envelope(root, solution);
    write_zones(root, solution.zones);
    write_certificate(root, solution.certificate.undecided);
    write_notes(root, solution.judgement);
    write_summary(root, solution);
    write_timing(root, solution.timing);
}

void layout::write_circular_spline(layout::Writer const& place, CircularSplineOutline const& outline)
{
    std::size_t const slices = outline.outline.size();
    std::size_t const points = slices == 0 ? 0 : outline.outline.front().size();
    std::vector<double> flat;  // one slice is written as it lies
    flat.reserve(slices > 1 ? slices * points * 2 : 0);
    for (auto const& slice : outline.outline) {
        if (slice.size() != points || outline.z.size() != slices)
            throw std::logic_error("slices of the circular spline do not match each other or z");
        if (slices > 1 && points > 0)
            flat.insert(flat.end(), slice.front().data(), slice.front().data() + 2 * points);
    }
    double const* const first = slices == 1 && points > 0 ? outline.outline.front().front().data() : flat.data();
    place.numbers("z", outline.z, {"mm", "slices, 0 in the middle of the bearing", {"z"}, Owner::result});
    place.array("outline", {slices, points, 2}, first,
                {"mm",
                 "one pitch from mid-land to mid-land, x increasing",
                 {"z", "point", "xy"},
                 slices == 1 ? Owner::result : Owner::writer});
    place.integers("landmarks", outline.landmarks,
                   {"1", "points at land corners, flank ends and the middle", {"landmarks"}});
    write_pieces(place, outline.pieces);
}

void layout::write_result(Writer const& root, Solution const& solution)
{
    write_solution(root, solution);
    root.group("circular_spline", [&](Writer const& place) { write_circular_spline(place, solution.circular_spline); });
}

void layout::write_result(Writer const& root, WantedCurve const& found)
{
    constexpr int wanted_version = 1;
    write_origin(root, "hdconj-neutral-curve", wanted_version, found.scene);
    write_scene(root, found.scene);
    root.attribute("kinematics", std::string(to_string(found.scene.solver.kinematics)));
    if (!found.notes.empty())
        root.attribute("notes", found.notes);
    root.points("neutral_curve", found.neutral_curve, "deformed neutral curve in the fixed frame, closed",
                "curve_point");
    root.points("inner_surface", found.inner_surface, "surface of the cam, parallel to the neutral curve",
                "curve_point");
    root.group("wanted_curve", [&](Writer const& place) {
        write_attributes(place, figures::wanted_figures(), found);
        place.attribute("ends", found.ends);
        write_columns(place, "row", figures::wanted_rows(), found.rows);
    });
}

}  // namespace hdconj::io
