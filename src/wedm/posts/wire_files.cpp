// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/wire_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "file/atomic_folder.hpp"
#include "grid.hpp"
#include "hdconj/base/suggest.hpp"
#include "hdconj/error.hpp"
#include "post.hpp"
#include "wedm/checks.hpp"

namespace hdconj::wedm {
namespace {

/// The program itself, so far as its numbers and the pairing of its points tell.
void check_program(WireProgram const& program)
{
    for (WireFailures const& failures : {check_numbers(program), check_pairing(program)})
        if (!failures.empty())
            refuse_to_write(program.name, failures.front());
}

/// A text: characters of its dialect, line lengths, printable ASCII.
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

/// What was read back against what should be there: as many points, each as near as the last digit allows; equal faces
/// must be read as equal.
/// @return largest distance along the whole path in both faces [mm]
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
        require(!untilted || read[i].lower == read[i].upper, which, "without a tilt both planes must be the same");
        for (std::size_t k = 0; k < exact[i].lower.size(); ++k) {
            Vec2 const lower = read[i].lower[k] - exact[i].lower[k], upper = read[i].upper[k] - exact[i].upper[k];
            require(lower.cwiseAbs().maxCoeff() <= allowed && upper.cwiseAbs().maxCoeff() <= allowed,
                    fmt::format("{}, point {}", which, k),
                    "what is read back is further from the exact point than one unit of the last digit");
            drift = std::max({drift, lower.norm(), upper.norm()});
        }
    }
    return drift;
}

}  // namespace
}  // namespace hdconj::wedm

namespace hdconj {
namespace {

constexpr char const* operator_name = "_summary.txt";

bool is_in(auto const& names, std::string_view name)
{
    return std::find(names.begin(), names.end(), name) != names.end();
}

void check_names(std::vector<std::string> const& dialects, std::string const& place)
{
    std::vector<std::string_view> known;
    for (auto const& dialect : wire_dialects())
        known.push_back(dialect.name);
    Faults faults;
    for (auto const& name : dialects) {
        if (!is_in(known, name)) {
            auto const meant = nearest(name, known);
            faults.push_back(
                {place, 0, name, "no dialect is called so",
                 meant ? "write " + std::string(*meant) : fmt::format("known: {}", fmt::join(known, ", "))});
        }
    }
    if (!faults.empty())
        throw InputError(std::move(faults));
}

std::vector<wedm::WirePost> chosen(WireSetUps const& programs, std::vector<std::string> const& dialects)
{
    check_names(dialects, "--dialect");
    auto fitting = fitting_dialects(programs.front());
    if (dialects.empty())
        for (auto const& unfit : unfit_dialects(programs))
            std::erase(fitting, unfit.name);
    std::vector<wedm::WirePost> posts;
    for (auto const& post : wedm::wire_posts()) {
        if (!is_in(dialects.empty() ? fitting : dialects, post.dialect.name))
            continue;
        if (!is_in(fitting, post.dialect.name))
            throw InputError(Fault{"--dialect", 0, std::string(post.dialect.name),
                                   "the faces differ, and this dialect has one contour for both",
                                   "write --tilt 0, or another dialect"});
        posts.push_back(post);
    }
    return posts;
}

/// Letters, digits, "._-": what every control takes for a name.
std::string stem_of(std::string const& part)
{
    constexpr std::size_t longest = 40;
    std::string stem;
    for (char const c : part.substr(0, longest)) {
        bool const kept = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
                          c == '_' || c == '-';
        stem += kept ? c : '-';
    }
    stem.erase(0, stem.find_first_not_of(".-"));
    return stem.empty() ? "part" : stem;
}

/// The least wedm.decimals above those of @p programs with which all @p posts hold them all; nothing where none does.
std::optional<int> fitting_decimals(std::vector<wedm::WirePost> const& posts, WireSetUps programs)
{
    constexpr int most = 9;
    for (int decimals = programs.front().decimals + 1; decimals <= most; ++decimals) {
        try {
            for (auto& program : programs) {
                program.decimals = decimals;
                for (auto const& post : posts)
                    (void)post.write(program, stem_of(program.name));
            }
            return decimals;
        } catch (NumericalError const& error) {
            if (error.code() != ErrorCode::no_room)
                throw;
        }
    }
    return {};
}

/// Files of one of @p posts. @throws NumericalError that names it, with what helps all of them
std::vector<wedm::WireText> texts_of(wedm::WirePost const& post, std::vector<wedm::WirePost> const& posts,
                                     WireProgram const& program, WireSetUps const& programs, std::string const& stem)
{
    try {
        return post.write(program, stem);
    } catch (NumericalError const& unfit) {
        if (unfit.code() != ErrorCode::no_room)
            throw;
        auto const decimals = fitting_decimals(posts, programs);
        throw NumericalError(
            ErrorCode::no_room, "wire files", fmt::format("{}, {}", post.dialect.name, unfit.place()), unfit.cause(),
            (decimals ? fmt::format("write wedm.decimals = {}", *decimals) : "take a coarser wedm.tolerance") +
                ", or another dialect");
    }
}

/// Writes the files of one of @p posts, reads them from the disk and compares.
std::vector<WireFile> write_one(file::AtomicFolder const& folder, wedm::WirePost const& post,
                                std::vector<wedm::WirePost> const& posts, WireProgram const& program,
                                WireSetUps const& programs, std::string const& stem)
{
    auto const made = texts_of(post, posts, program, programs, stem);
    std::vector<wedm::WireText> on_disk = made;
    for (std::size_t i = 0; i < made.size(); ++i) {
        wedm::check_text(post, made[i]);
        folder.write(made[i].name, made[i].text);
        on_disk[i].text = folder.read(made[i].name);
    }
    double const drift = wedm::check_paths(post, program, post.read(on_disk, program));
    std::vector<WireFile> files;
    for (auto const& each : made)
        files.push_back({std::string(post.dialect.name), post.dialect.verified_by, each.name, program.set_up.number,
                         each.pass, each.blocks, each.text.size(), post.unit(program), drift});
    return files;
}

std::string said_of(WireFile const& file)
{
    return fmt::format("{} blocks, {} bytes, {}, {}", file.blocks, file.bytes, file.dialect,
                       file.verified() ? fmt::format("read by: {}", file.verified_by) : "not verified on hardware");
}

}  // namespace

void check_wire_files(std::filesystem::path const& folder, std::vector<std::string> const& dialects,
                      std::string const& place)
{
    check_names(dialects, place);
    file::AtomicFolder::check(folder, file::AtomicFolder::wire_program);
}

std::vector<UnfitDialect> unfit_dialects(WireSetUps const& programs, std::vector<std::string> const& dialects)
{
    std::vector<UnfitDialect> unfit;
    for (auto const& post : wedm::wire_posts()) {
        if (!post.own_limits || (!dialects.empty() && !is_in(dialects, post.dialect.name)))
            continue;
        for (auto const& program : programs) {
            try {
                (void)post.write(program, stem_of(program.name));
            } catch (NumericalError const& cause) {
                if (cause.code() != ErrorCode::no_room)
                    throw;
                if (!fitting_decimals({post}, programs)) {
                    unfit.push_back({std::string(post.dialect.name), cause.place(), cause.cause()});
                    break;
                }
            }
        }
    }
    return unfit;
}

std::vector<WireFile> write_wire_files(WireSetUps const& programs, std::filesystem::path const& folder,
                                       std::vector<std::string> const& dialects)
{
    if (programs.empty())
        throw NumericalError(ErrorCode::failed_check, "wire files", "set-ups", "there is none: nothing was written");
    for (auto const& program : programs)
        wedm::check_program(program);
    auto const posts = chosen(programs, dialects);
    std::string const stem = stem_of(programs.front().name);
    file::AtomicFolder target(folder, file::AtomicFolder::wire_program);
    std::vector<WireFile> files;
    for (auto const& program : programs) {
        std::string const name = program.closed() ? stem : fmt::format("{}_setup{}", stem, program.set_up.number);
        for (auto const& post : posts) {
            auto const written = write_one(target, post, posts, program, programs, name);
            files.insert(files.end(), written.begin(), written.end());
        }
    }
    target.write(stem + operator_name, summary_text(programs, files));
    std::vector<std::pair<std::string, std::string>> lines;
    for (auto const& file : files)
        lines.emplace_back(file.name, said_of(file));
    lines.emplace_back(stem + operator_name, "for the operator of the machine");
    target.publish(lines);
    return files;
}

}  // namespace hdconj
