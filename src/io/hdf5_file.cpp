// SPDX-License-Identifier: GPL-3.0-or-later
// The layout of the result file, as docs/hdf5.md describes it.
#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <ctime>

#include "hdconj/io/result_files.hpp"
#include "hdconj/io/version.hpp"
#include "hdf5_layout.hpp"
#include "summary_figures.hpp"

namespace hdconj {

std::string hdf5::date_text()
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

namespace {

using hdf5::Writer;

/// Number of this layout; goes up when a reader of the old one would misread the new one.
constexpr int format_version = 1;

void write_provenance(Writer const& root, Solution const& solution)
{
    root.attribute("format", std::string("hdconj"));
    root.attribute("format_version", format_version);
    root.attribute("program_version", std::string(program_version()));
    root.attribute("git_revision", std::string(git_revision()));
    root.attribute("build", std::string(build_description()));
    root.attribute("date", hdf5::date_text());
    root.attribute("drive", solution.scene.drive.name);
    root.attribute("given", given_member(solution));
    root.attribute("scene", solution.scene.text);
    root.attribute("threads", solution.threads);
    root.attribute("plan", describe(solution.plan));
    std::vector<std::string> stages;
    for (auto const& planned : solution.plan.stages) {
        stages.push_back(to_string(planned.stage));
    }
    root.attribute("stages", stages);
    if (!solution.notes.empty()) {
        root.attribute("notes", solution.notes);
    }
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
    if (reverse) {
        branch.attribute("tooth", record.tooth);
    }
    branch.numbers("u", record.u, "rad");
    branch.numbers("phi", record.phi, "rad");
    branch.numbers("t", record.t, "1");
    branch.points("point", record.point);
}

void write_envelope(Writer const& root, Solution const& solution)
{
    root.group("envelope", [&](Writer const& envelope) {
        bool const reverse = solution.scene.is_reverse();
        envelope.attribute("segments", solution.segment_names);
        envelope.attribute("frame", std::string(reverse ? "flexspline tooth" : "circular spline"));
        for (std::size_t i = 0; i < solution.branches.size(); ++i) {
            envelope.group(fmt::format("branch_{:03}", i),
                           [&](Writer const& branch) { write_branch(branch, solution.branches[i], reverse); });
        }
    });
}

/// A column of the zones' table.
template <class Take>
std::vector<int> whole(std::vector<ConjugateZone> const& zones, Take take)
{
    std::vector<int> column;
    for (auto const& zone : zones) {
        column.push_back(static_cast<int>(take(zone)));
    }
    return column;
}

void write_intervals(Writer const& place, std::string const& name, std::vector<ConjugateZone> const& zones,
                     double ConjugateZone::*begin, double ConjugateZone::*end, char const* units)
{
    std::vector<double> pairs;
    for (auto const& zone : zones) {
        pairs.push_back(zone.*begin);
        pairs.push_back(zone.*end);
    }
    place.array(name, {zones.size(), 2}, pairs.data(), units);
}

void write_zones(Writer const& root, std::vector<ConjugateZone> const& zones)
{
    root.group("conjugate_zones", [&](Writer const& place) {
        place.integers("branch", whole(zones, [](auto const& zone) { return zone.branch; }));
        place.integers("segment", whole(zones, [](auto const& zone) { return zone.segment; }));
        place.integers("outer", whole(zones, [](auto const& zone) { return zone.outer; }));
        place.integers("on_boundary", whole(zones, [](auto const& zone) { return zone.on_boundary; }));
        write_intervals(place, "u", zones, &ConjugateZone::u_begin, &ConjugateZone::u_end, "rad");
        write_intervals(place, "phi", zones, &ConjugateZone::phi_begin, &ConjugateZone::phi_end, "rad");
        write_intervals(place, "t", zones, &ConjugateZone::t_begin, &ConjugateZone::t_end, "1");
    });
}

/// The places that keep a result from being certified; empty where it is.
void write_certificate(Writer const& root, std::vector<UndecidedPlace> const& places)
{
    auto const column = [&](auto member) {
        std::vector<double> values;
        for (auto const& place : places) {
            values.push_back(place.*member);
        }
        return values;
    };
    auto const texts = [&](auto member) {
        std::vector<std::string> values;
        for (auto const& place : places) {
            values.push_back(place.*member);
        }
        return values;
    };
    root.group("undecided", [&](Writer const& place) {
        place.texts("what", texts(&UndecidedPlace::what));
        place.texts("segment_name", texts(&UndecidedPlace::segment_name));
        place.numbers("t", column(&UndecidedPlace::t), "1");
        place.numbers("u", column(&UndecidedPlace::u), "rad");
        place.numbers("u_width", column(&UndecidedPlace::u_width), "rad");
        place.numbers("reach", column(&UndecidedPlace::reach), "mm");
    });
}

void write_pieces(Writer const& member, std::vector<OutlinePiece> const& pieces)
{
    std::vector<std::string> kinds, segments;
    std::vector<int> first, last;
    for (auto const& piece : pieces) {
        kinds.push_back(piece.kind);
        segments.push_back(piece.segment_name);
        first.push_back(static_cast<int>(piece.first));
        last.push_back(static_cast<int>(piece.last));
    }
    member.group("pieces", [&](Writer const& place) {
        place.texts("kind", kinds);
        place.texts("segment_name", segments);
        place.integers("first", first);
        place.integers("last", last);
    });
}

void write_summary(Writer const& root, Solution const& solution)
{
    root.group("summary", [&](Writer const& summary) {
        for (auto const& figure : figures(solution)) {
            summary.attribute(figure.key, figure.value);
        }
    });
}

void write_timing(Writer const& root, std::vector<StageTime> const& timing)
{
    std::vector<std::string> stages;
    std::vector<double> seconds;
    for (auto const& entry : timing) {
        stages.push_back(entry.stage);
        seconds.push_back(entry.seconds);
    }
    root.group("timing", [&](Writer const& place) {
        place.texts("stage", stages);
        place.numbers("seconds", seconds, "s");
    });
}

}  // namespace

void hdf5::write_solution(Writer const& root, Solution const& solution)
{
    write_provenance(root, solution);
    root.group("flexspline", [&](Writer const& place) {
        place.points("outline", solution.flexspline_outline);
        if (solution.scene.is_reverse()) {
            write_pieces(place, solution.flexspline_pieces);
        }
    });
    root.points("neutral_curve", solution.neutral_curve);
    write_envelope(root, solution);
    write_zones(root, solution.zones);
    write_certificate(root, solution.certificate.undecided);
    write_summary(root, solution);
    write_timing(root, solution.timing);
}

void hdf5::write_circular_spline(Writer const& place, CircularSplineOutline const& outline)
{
    std::size_t const slices = outline.outline.size();
    std::size_t const points = slices == 0 ? 0 : outline.outline.front().size();
    std::vector<double> flat;   // one slice is written as it lies
    flat.reserve(slices > 1 ? slices * points * 2 : 0);
    for (auto const& slice : outline.outline) {
        if (slice.size() != points || outline.z.size() != slices) {
            throw std::logic_error("slices of the circular spline do not match each other or z");
        }
        if (slices > 1) {
            for (auto const& point : slice) {
                flat.push_back(point.x());
                flat.push_back(point.y());
            }
        }
    }
    double const* const first = slices == 1 && points > 0 ? outline.outline.front().front().data() : flat.data();
    place.numbers("z", outline.z, "mm");
    place.array("outline", {slices, points, 2}, first, "mm");
    place.integers("landmarks", outline.landmarks);
    write_pieces(place, outline.pieces);
}

void write_hdf5(Solution const& solution, std::filesystem::path const& file)
{
    hdf5::write_file(file, [&](Writer const& root) {
        hdf5::write_solution(root, solution);
        root.group("circular_spline",
                   [&](Writer const& place) { hdf5::write_circular_spline(place, solution.circular_spline); });
    });
}

}  // namespace hdconj
