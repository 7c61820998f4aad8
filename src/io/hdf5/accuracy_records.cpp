// SPDX-License-Identifier: GPL-3.0-or-later
// Records as HDF5 and CSV; the layout is described in docs/reference/hdf5.md.
#include <fmt/format.h>

#include "figures/accuracy_figures.hpp"
#include "hdconj/read_scene.hpp"
#include "hdf5_columns.hpp"
#include "hdf5_layout.hpp"
#include "hdf5_reader.hpp"

namespace hdconj::io {
namespace {

constexpr int records_version = 2;
constexpr char const* format = "hdconj-accuracy";
constexpr hdf5::StoredKind stored_kind{"no file of records of a study",
                                       "make one: hdconj accuracy -o DIR, then give DIR/records.h5", "records.h5"};

AccuracyOrigin origin_of(hid_t file)
{
    return {hdf5::text_of(file, "program_version"), hdf5::text_of(file, "git_revision"), hdf5::text_of(file, "build"),
            hdf5::text_of(file, "libraries")};
}

std::vector<StudyRecord> records_of(hid_t file, bool format_1)
{
    hdf5::Group const place(H5Gopen2(file, "records", H5P_DEFAULT), "open the records");
    std::vector<StudyRecord> records(hdf5::texts_of(place, figures::record_texts().front().name).size());
    auto const fill = [&](auto const& values, auto set) {
        hdf5::require(values.size() == records.size(), "columns differ in length");
        for (std::size_t i = 0; i < values.size(); ++i)
            set(records[i], values[i]);
    };
    for (auto const& column : figures::record_texts())
        fill(hdf5::texts_of(place, column.name),
             [at = column.text](StudyRecord& record, std::string const& text) { record.*at = text; });
    for (auto const& [figure, set] : figures::record_figures()) {
        char const* const name = format_1 && figure.former != nullptr ? figure.former : figure.name;
        fill(hdf5::values_of<double>(hdf5::Opened(place, name, 1), H5T_NATIVE_DOUBLE), set);
    }
    return records;
}

AccuracyReport report_of(hid_t file, std::filesystem::path const& name)
{
    AccuracyReport report;
    report.machine = hdf5::text_of(file, "machine");
    report.scene = parse_scene(hdf5::text_of(file, "scene"), name.string());
    report.scene.drive.name = hdf5::text_of(file, "drive");
    report.threads = hdf5::number_of(file, "threads");
    report.sample = hdf5::number_of(file, "sample");
    report.sample_refused = hdf5::number_of(file, "sample_refused");
    report.quick = hdf5::number_of(file, "quick") != 0;
    report.reference_error = hdf5::number_of<double>(file, "reference_error_mm");
    bool const format_1 = hdf5::number_of(file, "format_version") == 1;
    report.reference_interference =
        hdf5::number_of<double>(file, format_1 ? "reference_entry_mm" : "reference_interference_mm");
    report.seconds = hdf5::number_of<double>(file, "seconds");
    report.notes = hdf5::texts_of(file, "notes");
    report.records = records_of(file, format_1);
    return report;
}

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

std::string hdf5::accuracy_bytes(StoredAccuracy const& study)
{
    hdf5::Silence const silence;
    hdf5::Sink sink;
    hdf5::NewFile made(sink);
    auto const root = made.root();
    auto const& report = study.report;
    root.attribute("format", std::string(format));
    root.attribute("format_version", records_version);
    root.attribute("program_version", study.origin.version);
    root.attribute("git_revision", study.origin.revision);
    root.attribute("build", study.origin.build);
    root.attribute("libraries", study.origin.libraries);
    root.attribute("date", hdf5::date_text());
    root.attribute("machine", report.machine);
    root.attribute("drive", report.scene.drive.name);
    root.attribute("scene", report.scene.text);
    hdf5::write_attributes(root, figures::report_figures(), report);
    root.group("records", [&](hdf5::Writer const& records) {
        for (auto const& column : figures::record_texts())
            records.texts(column.name, hdf5::column(report.records, column.text), column.meaning, "record");
        for (auto const& [figure, set] : figures::record_figures())
            hdf5::write_named(records, {figure.name, figure.former}, [&, &column = figure](char const* name) {
                records.numbers(name, hdf5::column(report.records, column.value),
                                {column.unit.stored, column.meaning, {"record"}});
            });
    });
    root.texts("notes", report.notes, "what a reader should know", "note");
    made.flush();
    return sink.bytes();
}

std::string hdf5::stored_drive(std::filesystem::path const& file)
{
    return hdf5::read_stored(file, stored_kind,
                             [](hdf5::File const& opened) { return hdf5::text_of(opened, "drive"); });
}

}  // namespace hdconj::io

namespace hdconj {

StoredAccuracy read_accuracy(std::filesystem::path const& file)
{
    return io::hdf5::read_stored(file, io::stored_kind, [&](io::hdf5::File const& opened) {
        io::hdf5::require(io::hdf5::text_of(opened, "format") == io::format, "it is of another program or verb");
        io::hdf5::require(io::hdf5::number_of(opened, "format_version") <= io::records_version,
                          "it was written by a newer version");
        return StoredAccuracy{io::report_of(opened, file), io::origin_of(opened)};
    });
}

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
    auto const number = [](double value) { return value == value ? fmt::format("{}", value) : std::string(); };
    std::string const origin = io::cell(study.origin.version) + "," + io::cell(study.origin.revision) + "," +
                               io::cell(study.origin.build) + "," + io::cell(study.origin.libraries);
    for (auto const& record : study.report.records) {
        for (auto const& column : figures::record_texts())
            text += io::cell(record.*column.text) + ",";
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
