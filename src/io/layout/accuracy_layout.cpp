// SPDX-License-Identifier: GPL-3.0-or-later
// The layout of the records of a study, as docs/reference/hdf5.md describes it, and the same as CSV.
#include <fmt/format.h>

#include "columns.hpp"
#include "figures/accuracy_figures.hpp"
#include "results.hpp"

namespace hdconj::io {

void layout::write_result(Writer const& root, StoredAccuracy const& study)
{
    auto const& report = study.report;
    root.attribute("format", std::string(accuracy_format));
    root.attribute("format_version", accuracy_version);
    root.attribute("program_version", study.origin.version);
    root.attribute("git_revision", study.origin.revision);
    root.attribute("build", study.origin.build);
    root.attribute("libraries", study.origin.libraries);
    root.attribute("date", date_text());
    root.attribute("machine", report.machine);
    root.attribute("drive", report.scene.drive.name);
    layout::write_scene(root, report.scene);
    write_attributes(root, figures::report_figures(), report);
    root.group("records", [&](Writer const& records) {
        for (auto const& column : figures::record_texts())
            records.texts(column.name, layout::column(report.records, column.text), column.meaning, "record");
        for (auto const& [figure, set] : figures::record_figures())
            write_named(records, {figure.name, figure.former}, [&, &column = figure](char const* name) {
                records.numbers(name, layout::column(report.records, column.value),
                                {column.unit.stored, column.meaning, {"record"}});
            });
    });
    root.texts("notes", report.notes, "what a reader should know", "note");
}

}  // namespace hdconj::io

namespace hdconj {
namespace {

/// A cell of a table: in quotes where a comma or a quote would end it.
std::string cell(std::string const& text)
{
    if (text.find_first_of(",\"\n") == std::string::npos)
        return text;
    std::string quoted = "\"";
    for (char const c : text)
        quoted += c == '"' ? "\"\"" : std::string(1, c);
    return quoted + '"';
}

}  // namespace

std::string accuracy_csv(StoredAccuracy const& study)
{
    std::string text;
    for (auto const& column : figures::record_texts())
        text += std::string(column.name) + ",";
    for (auto const& [figure, set] : figures::record_figures())
        text += std::string(figure.name) + ",";
    text += "version,revision,compiler_and_flags,libraries";
    for (auto const& [figure, set] : figures::record_figures())
        if (figure.former != nullptr)
            text += std::string(",") + figure.former;
    text += "\n";
    auto const number = [](double value) { return std::isnan(value) ? std::string() : fmt::format("{}", value); };
    std::string const origin = cell(study.origin.version) + "," + cell(study.origin.revision) + "," +
                               cell(study.origin.build) + "," + cell(study.origin.libraries);
    for (auto const& record : study.report.records) {
        for (auto const& column : figures::record_texts())
            text += cell(record.*column.text) + ",";
        for (auto const& [figure, set] : figures::record_figures())
            text += number(figure.value(record)) + ",";
        text += origin;
        for (auto const& [figure, set] : figures::record_figures())
            if (figure.former != nullptr)
                text += "," + number(figure.value(record));
        text += "\n";
    }
    return text;
}

}  // namespace hdconj
