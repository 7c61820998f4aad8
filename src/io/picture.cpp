// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cctype>
#include <chrono>

#include "hdconj/io/atomic_file.hpp"
#include "hdconj/io/result_files.hpp"
#include "hdconj/scene/fault.hpp"
#include "picture_file.hpp"
#include "picture_gnuplot.hpp"
#include "picture_script.hpp"

namespace hdconj {

PictureFormat format_of(std::filesystem::path const& file)
{
    std::string ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (ending == ".svg") {
        return PictureFormat::svg;
    }
    if (ending == ".png") {
        return PictureFormat::png;
    }
    throw InputError(Fault{"--picture", 0, file.string(),
                           "the ending says what to draw, and only .svg and .png are known",
                           "write NAME.svg or NAME.png"});
}

void draw_picture(std::string const& script, std::filesystem::path const& file)
{
    std::string drawing;
    try {
        drawing = gnuplot::draw(script);
    } catch (std::runtime_error const& error) {
        throw FileError(file, error.what());
    }
    write_text_atomically(file, drawing);
}

std::filesystem::path picture_part(std::filesystem::path const& file, std::string const& what)
{
    auto name = file.stem();
    name += "-" + what;
    name += file.extension();
    return file.parent_path() / name;
}

WrittenFile drawn(std::string const& kind, std::string const& script, std::filesystem::path const& file)
{
    auto const begin = std::chrono::steady_clock::now();
    draw_picture(script, file);
    return {kind, file, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count()};
}

void check_picture(std::filesystem::path const& file)
{
    (void)format_of(file);
    check_target(file);
    if (!gnuplot::is_installed()) {
        throw FileError(file, gnuplot::missing);
    }
}

void write_picture(Solution const& solution, std::filesystem::path const& file)
{
    check_picture(file);
    draw_picture(picture_script(solution, format_of(file)), file);
}

}  // namespace hdconj
