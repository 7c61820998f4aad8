// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A post: one dialect, how it is written and how it is read back; private to src/io. A new dialect is one file with one function that
/// returns a WirePost, and its line in wire_posts.cpp.
#pragma once

#include <string>
#include <vector>

#include "hdconj/io/wire_files.hpp"
#include "hdconj/wedm/wire_program.hpp"

namespace hdconj {

/// A file, ready to be written.
struct WireText
{
    std::string name;
    std::string text;
    int pass = 0;             ///< 0: all passes
    std::size_t blocks = 0;
};

/// Wire, or contour, by its points in both faces.
struct FacePath
{
    std::string what;         ///< for messages: "pass 1"
    std::vector<Vec2> lower;
    std::vector<Vec2> upper;
};

/// "NAME_xyuv_guide_pass1.ngc"
[[nodiscard]] std::string pass_file(std::string const& stem, std::string const& what, WirePass const& pass, std::string const& ending);

/// A file for each pass, a block for each of its moves: text_of(program, pass).
template <class TextOf>
std::vector<WireText> write_each(WireProgram const& program, std::string const& stem, std::string const& what, std::string const& ending, TextOf text_of)
{
    std::vector<WireText> files;
    for (auto const& pass : program.passes) {
        files.push_back({pass_file(stem, what, pass, ending), text_of(program, pass), pass.number, pass.moves.size() - 1});
    }
    return files;
}

/// Reads every file of a dialect whose files hold one pass each.
template <FacePath (*read_one)(WireText const&)>
std::vector<FacePath> read_each(std::vector<WireText> const& files, WireProgram const& /*program*/)
{
    std::vector<FacePath> paths;
    for (auto const& file : files) {
        paths.push_back(read_one(file));
    }
    return paths;
}

struct WirePost
{
    WireDialect dialect;
    std::size_t longest_line = 80;                 ///< that a file may have
    std::string_view alphabet;                     ///< characters outside comments; empty: all that can be printed
    bool own_limits = false;                       ///< a grid, or longest files, that no key of the scene changes
    double (*unit)(WireProgram const&) = nullptr;  ///< last digit [mm]
    double (*allowed)(WireProgram const&) = nullptr;  ///< distance of what is read back from the exact [mm]; none: one unit
    /// Files of @p program; names begin with @p stem.
    std::vector<WireText> (*write)(WireProgram const& program, std::string const& stem) = nullptr;
    /// What the files say, exactly.
    std::vector<FacePath> (*exact)(WireProgram const& program) = nullptr;
    /// Reads the files back, without the writer's means. @throws NumericalError with file, line and cause
    std::vector<FacePath> (*read)(std::vector<WireText> const& files, WireProgram const& program) = nullptr;
};

WirePost dxf_post();
WirePost xyuv_guide_post();
WirePost xyuv_face_post();
WirePost csv_post();
WirePost relative_post();
WirePost colon_post();
WirePost three_b_post();
WirePost iso2d_post();

/// All of them, in the order written.
[[nodiscard]] std::vector<WirePost> const& wire_posts();

/// The last digit of the program's own decimals [mm].
[[nodiscard]] double program_unit(WireProgram const& program);

/// The passes, as they are.
[[nodiscard]] std::vector<FacePath> exact_passes(WireProgram const& program);

/// Whether both faces are the same, contour and wire, bit for bit.
[[nodiscard]] bool is_untilted(WireProgram const& program);

/// A text that may stand in a comment of every dialect that has comments: ASCII, no brackets, cut to @p longest.
[[nodiscard]] std::string comment_text(std::string const& text, std::size_t longest);

/// What machine operators must see before they cut, one short line each: part, pass, wire and gap, planes, which face is larger.
[[nodiscard]] std::vector<std::string> heading(WireProgram const& program, WirePass const* pass);

/// "SMALLER than the lower face", "LARGER ...", "as ...": of the upper face.
[[nodiscard]] std::string upper_face_words(WireFigures const& figures);

/// Estimated error of WireFigures::constant_taper_error: between its points, and by that of both contours and of what the tip land moves [mm].
[[nodiscard]] inline double taper_known_to(WireProgram const& program, WireFigures const& figures)
{
    return figures.constant_taper_spread + 3 * program.contour_error;
}

/// "set-up 1 of 2: 100 spaces from 0 clockwise, part turned 0 deg"
[[nodiscard]] std::string set_up_words(WireProgram const& program);

}  // namespace hdconj
