// SPDX-License-Identifier: GPL-3.0-or-later
// The picture files of all verbs but accuracy: their names, what can be known before the work, and which of them a
// result has something to draw for.
#include <algorithm>
#include <chrono>

#include "file/csv.hpp"
#include "gnuplot.hpp"
#include "hdconj/contact_files.hpp"
#include "hdconj/error.hpp"
#include "hdconj/file/atomic_file.hpp"
#include "hdconj/inspect_files.hpp"
#include "hdconj/load_files.hpp"
#include "hdconj/running_files.hpp"
#include "hdconj/wanted_curve_files.hpp"
#include "hdconj/wire_files.hpp"
#include "plots.hpp"

namespace hdconj::report {
namespace {

/// Whether the file's ending asks for PNG, not SVG. @throws InputError for an ending that is not known
bool is_png(std::filesystem::path const& file)
{
    std::string const ending = file::lower_case(file.extension().string());
    if (ending != ".svg" && ending != ".png") {
        throw InputError(Fault{"--picture", 0, file.string(),
                               "the ending says what to draw, and only .svg and .png are known",
                               "write NAME.svg or NAME.png"});
    }
    return ending == ".png";
}

/// Draws and writes the file, timed for the summaries. @throws FileError as drawing(), or where it cannot be written
WrittenFile write_drawing(std::string const& kind, std::string const& script, std::filesystem::path const& file)
{
    auto const begin = std::chrono::steady_clock::now();
    file::write_text_atomically(file, drawing(script, file));
    return {kind, file, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count()};
}

void check_pictures(std::vector<std::filesystem::path> const& files)
{
    std::for_each(files.begin(), files.end(), check_picture);
}

}  // namespace

std::filesystem::path picture_part(std::filesystem::path const& file, std::string const& what)
{
    return file.parent_path() / (file.stem().string() + "-" + what + file.extension().string());
}

std::string drawing(std::string const& script, std::filesystem::path const& file)
{
    try {
        return gnuplot::draw((is_png(file) ? "png = 1\n" : "png = 0\n") + script);
    } catch (gnuplot::GnuplotError const& error) {
        throw FileError(file, error.what());
    }
}

}  // namespace hdconj::report

namespace hdconj {

using report::picture_part, report::write_drawing;

void check_picture(std::filesystem::path const& file)
{
    (void)report::is_png(file);
    file::check_target(file);
    if (!report::gnuplot::is_installed())
        throw FileError(file, report::gnuplot::missing);
}

void write_picture(Solution const& solution, std::filesystem::path const& file)
{
    check_picture(file);
    write_drawing("picture", report::tooth_space_script(solution), file);
}

void write_picture(WantedCurve const& found, std::filesystem::path const& file)
{
    check_picture(file);
    write_drawing("picture", report::wanted_curve_script(found), file);
}

void write_chart(Inspection const& inspection, std::filesystem::path const& file)
{
    check_picture(file);
    write_drawing("picture", report::inspect_chart_script(inspection), file);
}

ContactPictures contact_picture_names(std::filesystem::path const& file)
{
    return {picture_part(file, "tilt"), picture_part(file, "map"), picture_part(file, "flank")};
}

void check_contact_pictures(std::filesystem::path const& file)
{
    auto const [tilt, map, flank] = contact_picture_names(file);
    report::check_pictures({tilt, map, flank});
}

std::vector<WrittenFile> write_contact_pictures(ContactStudy const& study, std::filesystem::path const& file)
{
    check_contact_pictures(file);
    auto const [tilt, map, flank] = contact_picture_names(file);
    std::vector<WrittenFile> written;
    if (report::has_tilt_curve(study))
        written.push_back(write_drawing("picture_tilt", report::tilt_script(study), tilt));
    if (!study.map.gap.empty()) {
        written.push_back(write_drawing("picture_map", report::map_script(study), map));
        written.push_back(write_drawing("picture_flank", report::flank_script(study), flank));
    }
    return written;
}

LoadPictures load_picture_names(std::filesystem::path const& file)
{
    return {picture_part(file, "curve"),  picture_part(file, "stiffness"), picture_part(file, "pressure"),
            picture_part(file, "flank"),  picture_part(file, "residual"),  picture_part(file, "cup"),
            picture_part(file, "stress"), picture_part(file, "balls")};
}

void check_load_pictures(std::filesystem::path const& file)
{
    auto const [curve, stiffness, pressure, flank, residual, cup, stress, balls] = load_picture_names(file);
    report::check_pictures({curve, stiffness, pressure, flank, residual, cup, stress, balls});
}

std::vector<WrittenFile> write_load_pictures(LoadStudy const& study, std::filesystem::path const& file,
                                             Measurement const* measured)
{
    check_load_pictures(file);
    auto const names = load_picture_names(file);
    std::vector<WrittenFile> written;
    if (report::has_curve(study) || measured != nullptr)
        written.push_back(write_drawing("picture_curve", report::load_curve_script(study, measured), names.curve));
    if (report::has_curve(study))
        written.push_back(write_drawing("picture_stiffness", report::load_stiffness_script(study), names.stiffness));
    if (measured != nullptr)
        written.push_back(
            write_drawing("picture_residual", report::load_residual_script(study, *measured), names.residual));
    if (auto const* shown = figures::shown_case(study); shown != nullptr && !shown->map.angle.empty())
        written.push_back(write_drawing("picture_pressure", report::load_pressure_script(study), names.pressure));
    if (report::has_loaded_flank(study))
        written.push_back(write_drawing("picture_flank", report::load_flank_script(study), names.flank));
    if (!study.shape.cells.empty()) {
        written.push_back(write_drawing("picture_cup", report::load_cup_script(study), names.cup));
        if (!study.shape.stress.empty())
            written.push_back(write_drawing("picture_stress", report::load_stress_script(study), names.stress));
    }
    if (report::has_balls(study))
        written.push_back(write_drawing("picture_balls", report::load_ball_script(study), names.balls));
    return written;
}

RunPictures run_picture_names(std::filesystem::path const& file)
{
    return {picture_part(file, "error"), picture_part(file, "spectrum"), picture_part(file, "efficiency")};
}

void check_run_pictures(std::filesystem::path const& file)
{
    auto const names = run_picture_names(file);
    report::check_pictures({names.error, names.spectrum, names.efficiency});
}

std::vector<WrittenFile> write_run_pictures(RunStudy const& study, std::filesystem::path const& file)
{
    check_run_pictures(file);
    auto const names = run_picture_names(file);
    std::vector<WrittenFile> written = {
        write_drawing("picture_error", report::run_error_script(study), names.error),
        write_drawing("picture_spectrum", report::run_spectrum_script(study), names.spectrum)};
    if (study.losses)
        written.push_back(write_drawing("picture_efficiency", report::run_efficiency_script(study), names.efficiency));
    return written;
}

WirePictures wire_picture_names(std::filesystem::path const& file, std::size_t set_ups)
{
    WirePictures names{picture_part(file, "tooth"), {}, picture_part(file, "residual")};
    for (std::size_t i = 1; i <= set_ups; ++i)
        names.rings.push_back(picture_part(file, set_ups == 1 ? "ring" : "ring" + std::to_string(i)));
    return names;
}

void check_wire_pictures(std::filesystem::path const& file, std::size_t set_ups)
{
    auto const names = wire_picture_names(file, set_ups);
    report::check_pictures({names.tooth, names.residual});
    report::check_pictures(names.rings);
}

std::vector<WrittenFile> write_wire_pictures(WireSetUps const& programs, std::filesystem::path const& file)
{
    check_wire_pictures(file, programs.size());
    auto const names = wire_picture_names(file, programs.size());
    std::vector<WrittenFile> written = {
        write_drawing("picture_tooth", report::wire_tooth_script(programs.front()), names.tooth)};
    for (std::size_t i = 0; i < programs.size(); ++i) {
        std::string const kind = "picture_ring" + (programs.size() == 1 ? "" : std::to_string(i + 1));
        written.push_back(write_drawing(kind, report::wire_ring_script(programs[i]), names.rings[i]));
    }
    if (std::any_of(programs.begin(), programs.end(), [](auto const& program) { return !program.residuals.empty(); }))
        written.push_back(write_drawing("picture_residual", report::wire_residual_script(programs), names.residual));
    return written;
}

}  // namespace hdconj
