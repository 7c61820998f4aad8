// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/accuracy_files.hpp"

#include "figures/accuracy_figures.hpp"
#include "file/atomic_folder.hpp"
#include "gnuplot.hpp"
#include "hdconj/error.hpp"
#include "hdconj/file/atomic_file.hpp"
#include "io/hdf5/hdf5_files.hpp"
#include "plots.hpp"

namespace hdconj {
namespace fs = std::filesystem;

void check_accuracy_folder(fs::path const& folder, std::string const& drive)
{
    file::AtomicFolder::check(folder, file::AtomicFolder::accuracy_study);
    std::error_code error;
    fs::path const records = folder / "records.h5";
    if (!fs::exists(records, error))
        return;
    std::string held;
    try {
        held = io::hdf5::stored_drive(records);
    } catch (InputError const&) {
        return;  // damaged, and of no use to anybody
    }
    if (held != drive)
        throw FileError(folder, "holds the study of another drive, \"" + held + "\" (write the name of a new folder)");
}

std::vector<WrittenFile> write_accuracy_folder(StoredAccuracy const& study, fs::path const& folder)
{
    check_accuracy_folder(folder, study.report.scene.drive.name);
    file::AtomicFolder made(folder, file::AtomicFolder::accuracy_study);
    std::vector<WrittenFile> files;
    std::vector<std::pair<std::string, std::string>> lines;
    auto const write = [&](std::string const& name, std::string const& kind, std::string const& content,
                           std::string const& said) {
        made.write(name, content);
        files.push_back({kind, folder / name, 0});
        lines.emplace_back(name, said);
    };
    try {
        write("records.h5", "hdf5", io::hdf5::accuracy_bytes(study),
              "one record for each case, method, knob and repeat");
    } catch (io::hdf5::Failure const& failure) {
        throw FileError(folder / "records.h5", failure.what());
    }
    write("records.csv", "csv", accuracy_csv(study), "the same as a table");
    auto const series_list = accuracy::convergence_series(study.report);
    if (report::gnuplot::is_installed()) {
        for (auto const& name : figures::studies_of(series_list)) {
            if (!report::has_picture(series_list, name))
                continue;
            for (auto const& file : {name + ".svg", name + ".png"}) {
                write(file, "picture",
                      report::drawing(report::accuracy_script(study, series_list, name), folder / file),
                      report::picture_words(series_list, name));
            }
        }
    }
    made.publish(lines);
    return files;
}

std::vector<WrittenFile> write_accuracy_page(StoredAccuracy const& study, fs::path const& page)
{
    auto const series_list = accuracy::convergence_series(study.report);
    std::vector<WrittenFile> files;
    if (report::gnuplot::is_installed()) {
        std::error_code ignored;  // where it cannot be made, the first picture says why
        fs::create_directories(accuracy_figure(page, "").parent_path(), ignored);
        for (auto const& name : figures::studies_of(series_list)) {
            if (!report::has_picture(series_list, name))
                continue;
            fs::path const file = accuracy_figure(page, name);
            file::write_text_atomically(file, report::drawing(report::accuracy_script(study, series_list, name), file));
            files.push_back({"picture", file, 0});
        }
    }
    file::write_text_atomically(page, accuracy_page(study, page, report::gnuplot::is_installed()));
    files.push_back({"page", page, 0});
    return files;
}

}  // namespace hdconj
