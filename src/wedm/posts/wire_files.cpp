// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/wire_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <sstream>

#include "file/atomic_folder.hpp"
#include "file_checks.hpp"
#include "grid.hpp"
#include "hdconj/base/suggest.hpp"
#include "hdconj/error.hpp"
#include "hdconj/scene/reading.hpp"
#include "post.hpp"

namespace hdconj {
namespace {

bool is_in(auto const& names, std::string_view name)
{
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// The names in @p text between blanks and commas.
std::vector<std::string> several_names(std::string text)
{
    std::ranges::replace(text, ',', ' ');
    std::istringstream words(text);
    return {std::istream_iterator<std::string>(words), {}};
}

std::vector<wedm::WirePost> chosen(WireSetUps const& programs, std::vector<std::string> const& dialects)
{
    throw_if_any(check_dialects(dialects));
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

/// Files of @p program by @p post. @throws NumericalError with ErrorCode::no_room also where the last digit is too
/// coarse for the tolerance
std::vector<wedm::WireText> written(wedm::WirePost const& post, WireProgram const& program, std::string const& stem)
{
    double const unit = post.unit(program);
    if (unit > 0 && program.tolerance > 0) {
        auto const fault = scene::rounding_fault(static_cast<int>(std::lround(-std::log10(unit))), program.tolerance);
        if (!fault.empty())
            throw wedm::no_room(fmt::format("grid of {:g} mm", unit), fault);
    }
    return post.write(program, stem);
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
                    (void)written(post, program, stem_of(program.name));
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
        return written(post, program, stem);
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
                         each.pass, each.blocks, each.text.size(), post.unit(program), drift,
                         program.figures.face_error + drift});
    return files;
}

std::string said_of(WireFile const& file)
{
    return fmt::format("{} blocks, {} bytes, {}, {}", file.blocks, file.bytes, file.dialect,
                       file.verified() ? fmt::format("read by: {}", file.verified_by) : "not verified on hardware");
}

}  // namespace

Faults check_dialects(std::vector<std::string> const& dialects, std::string const& place)
{
    std::vector<std::string_view> known;
    for (auto const& dialect : wire_dialects())
        known.push_back(dialect.name);
    Faults faults;
    for (auto const& name : dialects) {
        if (is_in(known, name))
            continue;
        if (auto const several = several_names(name); several.size() > 1) {
            bool const option = place.starts_with("--");
            faults.push_back(
                {place, 0, name,
                 option ? "commas stand between several dialects" : "blanks stand between several dialects",
                 fmt::format("write {}", fmt::join(several, option ? "," : " "))});
            continue;
        }
        auto const meant = nearest(name, known);
        faults.push_back({place, 0, name, "no dialect is called so",
                          meant ? "write " + std::string(*meant) : fmt::format("known: {}", fmt::join(known, ", "))});
    }
    return faults;
}

void check_wire_files(std::filesystem::path const& folder, std::vector<std::string> const& dialects,
                      std::string const& place)
{
    throw_if_any(check_dialects(dialects, place));
    file::AtomicFolder::check(folder, file::AtomicFolder::wire_program);
}

std::vector<UnfitDialect> unfit_dialects(WireSetUps const& programs, std::vector<std::string> const& dialects)
{
    std::vector<UnfitDialect> unfit;
    for (auto const& post : wedm::wire_posts()) {
        bool const fits = !post.dialect.only_untilted || std::ranges::all_of(programs, is_untilted);
        // A dialect with the scene's own grid that is named tells the decimals to write.
        if (!fits || (!dialects.empty() && (!post.own_limits || !is_in(dialects, post.dialect.name))))
            continue;
        for (auto const& program : programs) {
            try {
                (void)written(post, program, stem_of(program.name));
            } catch (NumericalError const& cause) {
                if (cause.code() != ErrorCode::no_room)
                    throw;
                auto const decimals = fitting_decimals({post}, programs);
                if (dialects.empty() || !decimals) {
                    unfit.push_back({std::string(post.dialect.name), cause.place(), cause.cause(), decimals});
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
    std::vector<std::pair<std::string, std::string>> lines;
    for (auto const& file : files)
        lines.emplace_back(file.name, said_of(file));
    auto const add = [&](std::string const& ending, std::string const& text, char const* meaning) {
        target.write(stem + ending, text);
        lines.emplace_back(stem + ending, meaning);
    };
    add("_summary.txt", summary_text(programs, files), "for the operator of the machine");
    add("_setup.txt", setup_sheet_text(programs, files), "setup sheet");
    add("_setup.svg", setup_sheet_svg(programs, files), "setup sheet, with drawings");
    target.publish(lines);
    return files;
}

}  // namespace hdconj
