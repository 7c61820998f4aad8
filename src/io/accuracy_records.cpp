// SPDX-License-Identifier: GPL-3.0-or-later
// Records as HDF5 and CSV; the layout is described in docs/hdf5.md.
#include <fmt/format.h>

#include "accuracy_figures.hpp"
#include "accuracy_records.hpp"
#include "hdconj/io/scene_reading.hpp"
#include "hdf5_layout.hpp"
#include "hdf5_reader.hpp"

namespace hdconj {
namespace {

constexpr int format_version = 1;
constexpr char const* format = "hdconj-accuracy";
constexpr hdf5::StoredKind stored_kind{"no file of records of a study", "make one: hdconj accuracy -o DIR, then give DIR/records.h5", "records.h5"};

double real_of(hid_t place, char const* name)
{
    hdf5::Attribute const attribute(H5Aopen(place, name, H5P_DEFAULT), "open attribute");
    double value = 0;
    hdf5::checked(H5Aread(attribute, H5T_NATIVE_DOUBLE, &value), "read attribute");
    return value;
}

/// The scene that was given: the page says its wave generator, motion model and given tooth.
/// @throws InputError where this program does not take it
Scene scene_of(std::string const& text, std::filesystem::path const& file)
{
    SceneReading reading = examine_scene(text, file.string());
    if (!reading.faults.empty()) {
        throw InputError(std::move(reading.faults));
    }
    return std::move(reading.scene);
}

/// A cell of a table: in quotes where a comma or a quote would end it.
std::string cell(std::string const& text)
{
    if (text.find_first_of(",\"\n") == std::string::npos) {
        return text;
    }
    std::string quoted = "\"";
    for (char const c : text) {
        quoted += c == '"' ? "\"\"" : std::string(1, c);
    }
    return quoted + '"';
}

}  // namespace

std::string accuracy_bytes(StoredAccuracy const& study)
{
    hdf5::Silence const silence;
    hdf5::Sink sink;
    hdf5::NewFile const made(sink);
    auto const root = made.root();
    auto const& report = study.report;
    root.attribute("format", std::string(format));
    root.attribute("format_version", format_version);
    root.attribute("program_version", study.origin.version);
    root.attribute("git_revision", study.origin.revision);
    root.attribute("build", study.origin.build);
    root.attribute("libraries", study.origin.libraries);
    root.attribute("date", hdf5::date_text());
    root.attribute("machine", report.machine);
    root.attribute("drive", report.scene.drive.name);
    root.attribute("scene", report.scene.text);
    root.attribute("threads", report.threads);
    root.attribute("sample", report.sample);
    root.attribute("sample_refused", report.sample_refused);
    root.attribute("quick", report.quick ? 1 : 0);
    root.attribute("reference_error_mm", report.reference_error);
    root.attribute("reference_entry_mm", report.reference_entry);
    root.attribute("seconds", report.seconds);
    root.group("records", [&](hdf5::Writer const& records) {
        for (auto const& column : record_texts()) {
            std::vector<std::string> values;
            for (auto const& record : report.records) {
                values.push_back(record.*column.text);
            }
            records.texts(column.name, values);
        }
        for (auto const& column : record_figures()) {
            std::vector<double> values;
            for (auto const& record : report.records) {
                values.push_back(column.value(record));
            }
            records.numbers(column.name, values, column.units);
        }
    });
    root.texts("notes", report.notes);
    made.flush();
    return sink.bytes();
}

StoredAccuracy read_accuracy(std::filesystem::path const& file)
{
    using namespace hdf5;
    return read_stored(file, stored_kind, [&](File const& opened) {
        require(text_of(opened, "format") == format, "it is of another program or verb");
        require(number_of(opened, "format_version") <= format_version, "it was written by a newer version");
        StoredAccuracy study;
        study.origin = {text_of(opened, "program_version"), text_of(opened, "git_revision"), text_of(opened, "build"), text_of(opened, "libraries")};
        auto& report = study.report;
        report.machine = text_of(opened, "machine");
        report.scene = scene_of(text_of(opened, "scene"), file);
        report.scene.drive.name = text_of(opened, "drive");
        report.threads = number_of(opened, "threads");
        report.sample = number_of(opened, "sample");
        report.sample_refused = number_of(opened, "sample_refused");
        report.quick = number_of(opened, "quick") != 0;
        report.reference_error = real_of(opened, "reference_error_mm");
        report.reference_entry = real_of(opened, "reference_entry_mm");
        report.seconds = real_of(opened, "seconds");
        report.notes = texts_of(opened, "notes");
        Group const records(H5Gopen2(opened, "records", H5P_DEFAULT), "open the records");
        for (auto const& column : record_texts()) {
            auto const values = texts_of(records, column.name);
            report.records.resize(std::max(report.records.size(), values.size()));
            require(values.size() == report.records.size(), "columns differ in length");
            for (std::size_t i = 0; i < values.size(); ++i) {
                report.records[i].*column.text = values[i];
            }
        }
        for (auto const& column : record_figures()) {
            auto const values = values_of<double>(Opened(records, column.name, 1), H5T_NATIVE_DOUBLE);
            require(values.size() == report.records.size(), "columns differ in length");
            for (std::size_t i = 0; i < values.size(); ++i) {
                column.set(report.records[i], values[i]);
            }
        }
        return study;
    });
}

std::string stored_drive(std::filesystem::path const& file)
{
    return hdf5::read_stored(file, stored_kind, [](hdf5::File const& opened) { return hdf5::text_of(opened, "drive"); });
}

std::string accuracy_csv(StoredAccuracy const& study)
{
    std::string text;
    for (auto const& column : record_texts()) {
        text += std::string(column.name) + ",";
    }
    for (auto const& column : record_figures()) {
        text += std::string(column.name) + ",";
    }
    text += "version,revision,compiler_and_flags,libraries\n";
    std::string const origin = cell(study.origin.version) + "," + cell(study.origin.revision) + "," + cell(study.origin.build) + "," + cell(study.origin.libraries);
    for (auto const& record : study.report.records) {
        for (auto const& column : record_texts()) {
            text += cell(record.*column.text) + ",";
        }
        for (auto const& column : record_figures()) {
            double const value = column.value(record);
            text += value == value ? fmt::format("{},", value) : ",";
        }
        text += origin + "\n";
    }
    return text;
}

}  // namespace hdconj
