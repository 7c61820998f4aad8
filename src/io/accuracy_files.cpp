// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/io/accuracy_files.hpp"

#include <stdexcept>

#include "accuracy_figures.hpp"
#include "accuracy_records.hpp"
#include "atomic_folder.hpp"
#include "hdconj/io/atomic_file.hpp"
#include "hdconj/scene/fault.hpp"
#include "hdf5_handle.hpp"
#include "picture_gnuplot.hpp"

namespace hdconj {
namespace fs = std::filesystem;

namespace {

std::string drawn(std::string const& script, fs::path const& blamed)
{
    try {
        return gnuplot::draw(script);
    } catch (std::runtime_error const& error) {
        throw FileError(blamed, error.what());
    }
}

}  // namespace

void check_accuracy_folder(fs::path const& folder, std::string const& drive)
{
    AtomicFolder::check(folder, AtomicFolder::accuracy_study);
    std::error_code error;
    fs::path const records = folder / "records.h5";
    if (!fs::exists(records, error)) {
        return;
    }
    std::string held;
    try {
        held = stored_drive(records);
    } catch (InputError const&) {
        return;   // damaged, and of no use to anybody
    }
    if (held != drive) {
        throw FileError(folder, "holds the study of another drive, \"" + held + "\" (write the name of a new folder)");
    }
}

std::vector<WrittenFile> write_accuracy_folder(StoredAccuracy const& study, fs::path const& folder)
{
    check_accuracy_folder(folder, study.report.scene.drive.name);
    AtomicFolder made(folder, AtomicFolder::accuracy_study);
    std::vector<WrittenFile> files;
    std::vector<std::pair<std::string, std::string>> lines;
    auto const write = [&](std::string const& name, std::string const& kind, std::string const& content, std::string const& said) {
        made.write(name, content);
        files.push_back({kind, folder / name, 0});
        lines.emplace_back(name, said);
    };
    try {
        write("records.h5", "hdf5", accuracy_bytes(study), "one record for each case, method, knob and repeat");
    } catch (hdf5::Failure const& failure) {
        throw FileError(folder / "records.h5", failure.what());
    }
    write("records.csv", "csv", accuracy_csv(study), "the same as a table");
    auto const ladders = ladders_of(study.report);
    if (gnuplot::is_installed()) {
        for (auto const& name : studies_of(ladders)) {
            if (!has_picture(ladders, name)) {
                continue;
            }
            for (auto const& [ending, format] : {std::pair{".svg", PictureFormat::svg}, std::pair{".png", PictureFormat::png}}) {
                std::string const file = name + ending;
                write(file, "picture", drawn(accuracy_script(study, ladders, name, format), folder / file), picture_words(ladders, name));
            }
        }
    }
    made.publish(lines);
    return files;
}

fs::path accuracy_figure(fs::path const& page, std::string const& study)
{
    return page.parent_path() / "figures" / (page.stem().string() + "-" + study + ".svg");
}

std::vector<WrittenFile> write_accuracy_page(StoredAccuracy const& study, fs::path const& page)
{
    auto const ladders = ladders_of(study.report);
    std::vector<WrittenFile> files;
    if (gnuplot::is_installed()) {
        std::error_code ignored;
        fs::create_directories(accuracy_figure(page, "").parent_path(), ignored);   // where it cannot be made, the first picture says why
        for (auto const& name : studies_of(ladders)) {
            if (!has_picture(ladders, name)) {
                continue;
            }
            fs::path const file = accuracy_figure(page, name);
            write_text_atomically(file, drawn(accuracy_script(study, ladders, name, PictureFormat::svg), file));
            files.push_back({"picture", file, 0});
        }
    }
    write_text_atomically(page, accuracy_page(study, page, gnuplot::is_installed()));
    files.push_back({"page", page, 0});
    return files;
}

}  // namespace hdconj
