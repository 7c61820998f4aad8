// SPDX-License-Identifier: GPL-3.0-or-later
// A post: one dialect, how it is written and how it is read back. A new dialect is one file with one function that
// returns a WirePost, and its line in posts.cpp.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hdconj/wedm.hpp"
#include "hdconj/wire_files.hpp"

namespace hdconj::wedm {

/// A file, ready to be written.
struct WireText
{
    std::string name;
    std::string text;
    int pass = 0;  ///< 0: all passes
    std::size_t blocks = 0;
};

/// Wire, or contour, by its points in both faces.
struct FacePath
{
    std::string what;  ///< for messages: "pass 1"
    std::vector<Vec2> lower;
    std::vector<Vec2> upper;
    std::vector<std::size_t> stops{};  ///< numbers of the points behind which the program stops
};

/// "NAME_xyuv_guide_pass1.ngc"
[[nodiscard]] std::string pass_file(std::string const& stem, std::string const& what, WirePass const& pass,
                                    std::string const& ending);

/// A file for each pass, a block for each of its moves: text_of(program, pass).
template <class TextOf>
std::vector<WireText> write_each(WireProgram const& program, std::string const& stem, std::string const& what,
                                 std::string const& ending, TextOf text_of)
{
    std::vector<WireText> files;
    for (auto const& pass : program.passes)
        files.push_back(
            {pass_file(stem, what, pass, ending), text_of(program, pass), pass.number, pass.moves.size() - 1});
    return files;
}

/// Reads every file of a dialect whose files hold one pass each.
template <FacePath (*read_one)(WireText const&, WireProgram const&)>
std::vector<FacePath> read_each(std::vector<WireText> const& files, WireProgram const& program)
{
    std::vector<FacePath> paths;
    for (auto const& file : files)
        paths.push_back(read_one(file, program));
    return paths;
}

struct WirePost
{
    WireDialect dialect;
    std::size_t longest_line = 80;                 ///< that a file may have
    std::string_view alphabet{};                   ///< characters outside comments; empty: all that can be printed
    bool own_limits = false;                       ///< a grid, or longest files, that no key of the scene changes
    double (*unit)(WireProgram const&) = nullptr;  ///< last digit [mm]
    std::optional<double> allowed{};  ///< distance of what is read back from the exact [mm]; default: one unit
    /// Files of @p program; names begin with @p stem.
    std::vector<WireText> (*write)(WireProgram const& program, std::string const& stem) = nullptr;
    /// What the files say, exactly.
    std::vector<FacePath> (*exact)(WireProgram const& program) = nullptr;
    /// Reads the files back, without the writer's means. @throws NumericalError with file, line and cause
    std::vector<FacePath> (*read)(std::vector<WireText> const& files, WireProgram const& program) = nullptr;
    /// Largest distance of the wire's path from the exact one where the files say something else [mm]; null: they say
    /// the wire's path.
    double (*drift)(WireProgram const& program, std::vector<FacePath> const& read) = nullptr;
};

namespace dxf {
WirePost post();
}
namespace xyuv {
WirePost guide_post();
WirePost face_post();
}  // namespace xyuv
namespace csv {
WirePost post();
}
namespace relative_uv {
WirePost post();
}
namespace two_plane {
WirePost post();
}
namespace three_b {
WirePost post();
}
namespace iso_2d {
WirePost post();
}

/// All of them, in the order written.
[[nodiscard]] std::vector<WirePost> const& wire_posts();

/// The last digit of the program's own decimals [mm].
[[nodiscard]] double program_unit(WireProgram const& program);

/// The passes, as they are.
[[nodiscard]] std::vector<FacePath> exact_passes(WireProgram const& program);

/// The stop of @p program with two digits: "M00" or "M01".
[[nodiscard]] std::string two_digit_stop(WireProgram const& program);

/// A text that may stand in a comment of every dialect that has comments: ASCII, no brackets, no %
/// (the end of a file to controls), cut to @p longest.
[[nodiscard]] std::string comment_text(std::string const& text, std::size_t longest);

/// @throws NumericalError: nothing is written because of @p cause at @p place
[[noreturn]] void refuse_to_write(std::string const& place, std::string const& cause);

}  // namespace hdconj::wedm
