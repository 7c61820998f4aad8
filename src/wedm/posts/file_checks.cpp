// SPDX-License-Identifier: GPL-3.0-or-later
#include "file_checks.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "wedm/checks.hpp"

namespace hdconj::wedm {

void check_program(WireProgram const& program)
{
    for (WireFailures const& failures : {check_numbers(program), check_pairing(program)})
        if (!failures.empty())
            refuse_to_write(program.name, failures.front().cause);
}

void check_text(WirePost const& post, WireText const& file)
{
    std::size_t line = 1, column = 0;
    bool comment = false;
    auto const refuse = [&](std::string const& cause) {
        refuse_to_write(fmt::format("{}, line {}", file.name, line), cause);
    };
    for (char const c : file.text) {
        if (c == '\n') {
            ++line;
            column = 0;
            comment = false;
            continue;
        }
        if (++column > post.longest_line)
            refuse(fmt::format("more than {} characters", post.longest_line));
        comment = comment || c == '(';
        bool const printable = c >= ' ' && c <= '~';
        if (!printable || (!comment && !post.alphabet.empty() && post.alphabet.find(c) == std::string_view::npos))
            refuse(fmt::format("character {} does not belong into {}", static_cast<int>(static_cast<unsigned char>(c)),
                               post.dialect.name));
        comment = comment && c != ')';
    }
    if (column != 0)
        refuse("the file ends in the middle of a line");
}

double check_paths(WirePost const& post, WireProgram const& program, std::vector<FacePath> const& read)
{
    auto const exact = post.exact(program);
    std::string const place(post.dialect.name);
    auto const require = [](bool holds, std::string const& where, char const* cause) {
        if (!holds)
            refuse_to_write(where, cause);
    };
    require(read.size() == exact.size(), place, "passes are missing when it is read back");
    double const allowed = post.allowed.value_or(post.unit(program));
    bool const untilted = is_untilted(program);
    double drift = 0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        std::string const which = fmt::format("{}, {}", place, exact[i].what);
        require(read[i].lower.size() == exact[i].lower.size() && read[i].upper.size() == exact[i].upper.size(), which,
                "points are missing when it is read back");
        require(read[i].stops == exact[i].stops, which, "the stops are not where they should be when it is read back");
        require(!untilted || read[i].lower == read[i].upper, which, "without a tilt both planes must be the same");
        for (std::size_t k = 0; k < exact[i].lower.size(); ++k) {
            Vec2 const lower = read[i].lower[k] - exact[i].lower[k], upper = read[i].upper[k] - exact[i].upper[k];
            require(lower.cwiseAbs().maxCoeff() <= allowed && upper.cwiseAbs().maxCoeff() <= allowed,
                    fmt::format("{}, point {}", which, k),
                    "what is read back is further from the exact point than one unit of the last digit");
            drift = std::max({drift, lower.norm(), upper.norm()});
        }
    }
    return post.drift != nullptr ? post.drift(program, read) : drift;
}

}  // namespace hdconj::wedm
