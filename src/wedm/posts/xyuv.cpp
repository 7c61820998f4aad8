// SPDX-License-Identifier: GPL-3.0-or-later
// RS274 with independent upper axes, as hot-wire and wire machines under LinuxCNC and grblHAL take it: absolute mm,
// lines only, wire centre. Every block carries all four words; G61 (exact path), because blending rounds corners by
// more than a tooth allows. The two comments (AXIS,...) place the planes in LinuxCNC's preview.
#include <fmt/format.h>

#include "grid.hpp"
#include "post.hpp"
#include "reading.hpp"
#include "wedm/planes.hpp"
#include "wedm/program_words.hpp"

namespace hdconj::wedm::xyuv {
namespace {

constexpr std::size_t longest_comment = 78;
constexpr char const* feed = "F2.0\n";  // mm/min; the generator's servo overrides it

/// Steps of N 10 where they stay within five digits, which is what RS274 allows; 1, or none, for long programs.
std::size_t number_step(std::size_t blocks)
{
    constexpr std::size_t most = 99999, wide = 10;
    return blocks * wide <= most ? wide : blocks <= most ? 1 : 0;
}

std::string text_of(WireProgram const& program, WirePass const& pass, WirePlanes planes)
{
    WireGrid const grid(program.decimals);
    bool const guides = planes == WirePlanes::guides;
    auto const blocks = blocks_of(program, pass, planes, grid);
    std::string text = fmt::format("%\n(hdconj {}-plane XYUV absolute mm)\n", guides ? "guide" : "face");
    for (auto const& line : heading(program, &pass))
        text += "(" + comment_text(line, longest_comment) + ")\n";
    double const bottom = guides ? -program.machine.lower_guide : 0;
    double const top = program.machine.thickness + (guides ? program.machine.upper_guide : 0);
    text += fmt::format("(AXIS,XY_Z_POS,{:.3f})\n(AXIS,UV_Z_POS,{:.3f})\n", bottom + 0.0, top);
    text += "G17 G21 G90 G40 G49 G61 G94\n";
    text += feed;
    std::size_t const step = number_step(blocks.size());
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        if (step > 0)
            text += fmt::format("N{} ", (i + 1) * step);
        text += i == 0 ? "G0" : "G1";
        grid.put(text, " X", " Y", blocks[i].lower);
        grid.put(text, " U", " V", blocks[i].upper);
        text += blocks[i].tag == WireTag::stop ? fmt::format("\n{}\n", to_string(program.stop)) : "\n";
    }
    return text + "M2\n%\n";
}

template <WirePlanes planes>
FacePath read_one(WireText const& file, WireProgram const& program)
{
    FacePath path{file.name, {}, {}};
    for (auto const& line : lines_of(file)) {
        if (line.text() == "%")
            continue;
        auto const words = words_of(line, line.text());
        note_stop(line, words, program, path);
        if (!is_straight_move(words)) {
            if (has_word(words, 'X') || has_word(words, 'U'))
                line.refuse("coordinates without G0 or G1");
            continue;
        }
        WirePoints at{point_of(line, words), point_of(line, words, 'U', 'V')};
        if (planes == WirePlanes::guides)
            at = faces_of(program.machine, at);
        path.lower.push_back(at.lower);
        path.upper.push_back(at.upper);
    }
    return path;
}

template <WirePlanes planes>
WirePost post(WireDialect dialect)
{
    return {.dialect = dialect,
            .alphabet = "%GXYUVNFM0123456789.- ",
            .unit = program_unit,
            .write =
                [](WireProgram const& program, std::string const& stem) {
                    return write_each(
                        program, stem, planes == WirePlanes::guides ? "xyuv_guide" : "xyuv_face", "ngc",
                        [](WireProgram const& whole, WirePass const& pass) { return text_of(whole, pass, planes); });
                },
            .exact = exact_passes,
            .read = read_each<read_one<planes>>};
}

}  // namespace

WirePost guide_post()
{
    return post<WirePlanes::guides>({"xyuv-guide", "RS274 XYUV, wire in the planes of the guides", "LinuxCNC"});
}

WirePost face_post()
{
    return post<WirePlanes::faces>({"xyuv-face", "RS274 XYUV, wire in the faces of the workpiece", "LinuxCNC"});
}

}  // namespace hdconj::wedm::xyuv
