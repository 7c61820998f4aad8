// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "grid.hpp"
#include "hdconj/error.hpp"
#include "post.hpp"

namespace hdconj::wedm {

std::vector<WirePost> const& wire_posts()
{
    static std::vector<WirePost> const posts = {dxf::post(),     xyuv::guide_post(),  xyuv::face_post(),
                                                csv::post(),     relative_uv::post(), two_plane::post(),
                                                three_b::post(), iso_2d::post()};
    return posts;
}

}  // namespace hdconj::wedm

namespace hdconj {

std::vector<WireDialect> wire_dialects()
{
    std::vector<WireDialect> dialects;
    for (auto const& post : wedm::wire_posts())
        dialects.push_back(post.dialect);
    return dialects;
}

std::vector<std::string> fitting_dialects(WireProgram const& program)
{
    bool const untilted = is_untilted(program);
    std::vector<std::string> names;
    for (auto const& dialect : wire_dialects())
        if (untilted || !dialect.only_untilted)
            names.emplace_back(dialect.name);
    return names;
}

}  // namespace hdconj

namespace hdconj::wedm {

double program_unit(WireProgram const& program)
{
    return WireGrid(program.decimals).unit();
}

std::vector<FacePath> exact_passes(WireProgram const& program)
{
    std::vector<FacePath> paths;
    for (auto const& pass : program.passes) {
        auto& path = paths.emplace_back();
        path.what = fmt::format("pass {}", pass.number);
        for (auto const& move : pass.moves) {
            if (move.tag == WireTag::stop)
                path.stops.push_back(path.lower.size());
            path.lower.push_back(move.lower);
            path.upper.push_back(move.upper);
        }
    }
    return paths;
}

std::string two_digit_stop(WireProgram const& program)
{
    return fmt::format("M0{}", to_string(program.stop).substr(1));
}

std::string comment_text(std::string const& text, std::size_t longest)
{
    std::string result;
    for (char const c : text.substr(0, longest)) {
        bool const kept = c >= ' ' && c <= '~' && c != '(' && c != ')' && c != ';' && c != '%';
        result += kept ? c : '-';
    }
    return result;
}

std::string pass_file(std::string const& stem, std::string const& what, WirePass const& pass, std::string const& ending)
{
    return fmt::format("{}_{}_pass{}.{}", stem, what, pass.number, ending);
}

void refuse_to_write(std::string const& place, std::string const& cause)
{
    throw NumericalError(ErrorCode::failed_check, "wire files", place, cause + ": nothing was written");
}

}  // namespace hdconj::wedm
