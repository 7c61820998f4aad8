// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the records of a study.
#include "figures/accuracy_figures.hpp"
#include "hdconj/read_scene.hpp"
#include "hdf5_files.hpp"
#include "hdf5_group.hpp"
#include "hdf5_reader.hpp"

namespace hdconj::io {
namespace {

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
    report.scene = parse_scene(hdf5::text_of(file, "scene"), name.string(), name.parent_path(), {},
                               layout::files_of(hdf5::StoredFile(file)));
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

}  // namespace

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
        io::hdf5::require(io::hdf5::text_of(opened, "format") == io::layout::accuracy_format,
                          "it is of another program or verb");
        io::hdf5::require(io::hdf5::number_of(opened, "format_version") <= io::layout::accuracy_version,
                          "it was written by a newer version");
        return StoredAccuracy{io::report_of(opened, file), io::origin_of(opened)};
    });
}

}  // namespace hdconj
