// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "post.hpp"
#include "wedm/planes.hpp"
#include "wedm/program_words.hpp"

namespace hdconj::wedm {
namespace {

constexpr double largest_coordinate = 1e6;  // [mm]

void refuse_nothing(WirePass const& pass, std::size_t i, char const* plane, double unit)
{
    auto const& move = pass.moves[i];
    std::string const place =
        fmt::format("pass {}, block {} ({}, tooth {})", pass.number, i, to_string(move.tag), move.tooth);
    auto const& before = pass.moves[i - 1];
    bool const lower = move.lower == before.lower;
    if (lower || move.upper == before.upper)
        refuse_to_write(place, fmt::format("the block has no length in the {} plane", lower ? "lower" : "upper"));
    throw no_room(place, fmt::format("the block has no length in the {} plane when rounded to {:g} mm", plane, unit));
}

}  // namespace

WireGrid::WireGrid(int decimals) : decimals_(decimals)
{
    constexpr int most = 9;  // largest coordinate and its differences stay far inside long long
    if (decimals < 0 || decimals > most)
        throw NumericalError(ErrorCode::failed_check, "wire files", fmt::format("{} decimals", decimals),
                             fmt::format("0 to {} can be written", most));
    constexpr long long base = 10;
    for (int i = 0; i < decimals; ++i)
        scale_ *= base;
}

long long WireGrid::units(double mm) const
{
    if (!(std::abs(mm) <= largest_coordinate))
        throw NumericalError(ErrorCode::failed_check, "wire files", fmt::format("coordinate {} mm", mm),
                             "no machine reaches so far");
    return std::llround(mm * static_cast<double>(scale_));
}

void WireGrid::put(std::string& text, std::string_view word, long long units) const
{
    constexpr long long base = 10;
    constexpr std::size_t longest = 24;
    std::array<char, longest> digits = {};
    std::size_t at = longest;
    long long rest = units < 0 ? -units : units;
    for (int i = 0; rest > 0 || i <= decimals_; ++i) {
        if (i == decimals_ && decimals_ > 0)
            digits[--at] = '.';
        digits[--at] = static_cast<char>('0' + rest % base);
        rest /= base;
    }
    text += word;
    if (units < 0)
        text += '-';
    text.append(digits.data() + at, longest - at);
}

std::vector<WireBlock> blocks_of(WireProgram const& program, WirePass const& pass, WirePlanes planes,
                                 WireGrid const& grid, Vec2 const& origin)
{
    std::vector<WireBlock> blocks;
    blocks.reserve(pass.moves.size());
    for (std::size_t i = 0; i < pass.moves.size(); ++i) {
        auto const& move = pass.moves[i];
        WirePoints const faces{move.lower, move.upper};
        WirePoints const at = planes == WirePlanes::faces ? faces : guides_of(program.machine, faces);
        blocks.push_back({grid.units(at.lower - origin), grid.units(at.upper - origin), move.tag});
        if (i > 0 && blocks[i].lower == blocks[i - 1].lower)
            refuse_nothing(pass, i, "lower", grid.unit());
        if (i > 0 && blocks[i].upper == blocks[i - 1].upper)
            refuse_nothing(pass, i, "upper", grid.unit());
    }
    return blocks;
}

}  // namespace hdconj::wedm
