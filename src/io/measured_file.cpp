// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/io/measured_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <numbers>
#include <span>
#include <string_view>

#include "hdconj/scene/suggest.hpp"

namespace hdconj {
namespace {

constexpr double rad_per_deg = std::numbers::pi / 180;
constexpr double arcmin_per_deg = 60, arcsec_per_deg = 3600;
constexpr double nmm_per_nm = 1000;

struct Unit
{
    std::string_view name;  ///< small letters, no blanks and points
    double factor;          ///< to rad, N mm, A, counts
};
constexpr std::array torque_units = {Unit{"nm", nmm_per_nm}, Unit{"nmm", 1.0}, Unit{"mnm", 1.0}};
constexpr std::array current_units = {Unit{"a", 1.0}, Unit{"ma", 1e-3}};
constexpr std::array angle_units = {Unit{"deg", rad_per_deg}, Unit{"°", rad_per_deg}, Unit{"arcmin", rad_per_deg / arcmin_per_deg},
                                    Unit{"'", rad_per_deg / arcmin_per_deg}, Unit{"arcsec", rad_per_deg / arcsec_per_deg}, Unit{"rad", 1.0},
                                    Unit{"mrad", 1e-3}};
constexpr std::array position_units = {Unit{"counts", 1.0}, Unit{"count", 1.0}, Unit{"1", 1.0}};

/// What a column may be.
struct Quantity
{
    std::string_view name, also;
    std::span<Unit const> units;
    std::string_view known_units;
};
constexpr std::array quantities = {Quantity{"torque", "load", torque_units, "[N m], [N mm] or [mN m]"}, Quantity{"current", "motor current", current_units, "[A] or [mA]"},
                                   Quantity{"angle", "twist", angle_units, "[deg], [arcmin], [arcsec], [rad] or [mrad]"},
                                   Quantity{"position", "counts", position_units, "[counts]"}};
enum : std::size_t
{
    torque,
    current,
    angle,
    position
};

constexpr char const* how_to_begin = "begin the file with a line such as \"angle [arcmin], torque [N m]\" or \"current [A], position [counts]\"";

std::string_view trimmed(std::string_view text)
{
    constexpr std::string_view blanks = " \t\r\n\"";
    auto const begin = text.find_first_not_of(blanks);
    return begin == std::string_view::npos ? std::string_view() : text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

std::string small(std::string_view text, std::string_view without = "")
{
    std::string result;
    for (char const c : text) {
        if (without.find(c) == std::string_view::npos) {
            result += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
        }
    }
    return result;
}

std::vector<std::string_view> fields_of(std::string_view line, char separator)
{
    std::vector<std::string_view> fields;
    for (std::size_t begin = 0;;) {
        auto const end = line.find(separator, begin);
        fields.push_back(trimmed(line.substr(begin, end == std::string_view::npos ? end : end - begin)));
        if (end == std::string_view::npos) {
            return fields;
        }
        begin = end + 1;
    }
}

/// "N·m" and "N m" are one unit; the point in the middle has two bytes.
std::string plain_unit(std::string_view unit)
{
    std::string text = small(unit, " .*_");
    for (std::string_view const dot : {"\xc2\xb7", "\xe2\x8b\x85"}) {
        for (auto at = text.find(dot); at != std::string::npos; at = text.find(dot)) {
            text.erase(at, dot.size());
        }
    }
    return text;
}

struct Column
{
    std::size_t at = 0;    ///< from 0
    double factor = 0;
    std::string heading;   ///< as written; empty: no such column
};

/// Reads one file; keeps every fault.
class Reader
{
  public:
    Reader(std::filesystem::path const& file, MeasuredReading& result) : file_(file), name_(file.string()), result_(result) {}

    void read(RigOptions const& rig, double scene_ratio)
    {
        if (!open()) {
            return;
        }
        std::string line;
        int number = 0;
        while (std::getline(in_, line)) {
            ++number;
            std::string_view text = trimmed(line);
            constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
            if (number == 1 && text.starts_with(byte_order_mark)) {
                text.remove_prefix(byte_order_mark.size());
            }
            if (text.empty() || text.front() == '#') {
                continue;
            }
            if (separator_ == '\0') {
                if (!read_header(text, number)) {
                    return;
                }
                take_rig(rig, scene_ratio);
            } else if (!read_row(line, number)) {
                return;
            }
        }
        if (separator_ == '\0') {
            fault(0, "", "", "has no header and no samples", how_to_begin);
        }
    }

  private:
    void fault(int line, std::string path, std::string value, std::string reason, std::string remedy)
    {
        bool const of_file = line == 0;
        result_.faults.push_back({of_file ? "--measured" : std::move(path), line, of_file ? name_ : std::move(value), std::move(reason), std::move(remedy), of_file ? "" : name_});
    }

    bool open()
    {
        std::error_code error;
        if (std::filesystem::is_directory(file_, error)) {
            fault(0, "", "", "is a folder", "write the name of a CSV file");
        } else if (in_.open(file_); !in_) {
            fault(0, "", "", "cannot be read", "write the name of a CSV file that is there");
        } else if (!std::filesystem::is_regular_file(file_, error)) {
            fault(0, "", "", "is no file that ends", "write the name of a CSV file");
        } else if (std::filesystem::file_size(file_, error) > largest_measured_file) {
            fault(0, "", "", fmt::format("is larger than {} MiB", largest_measured_file >> 20), "keep every tenth sample or so");
        } else {
            return true;
        }
        return false;
    }

    /// Name and unit of one heading into the column that it is.
    void read_heading(std::string_view heading, std::size_t at, int line, std::vector<std::string_view>& unknown)
    {
        auto const open = heading.find_first_of("[(");
        std::string_view const name = trimmed(heading.substr(0, open));
        auto const found = std::find_if(quantities.begin(), quantities.end(), [&](Quantity const& each) { return small(name) == each.name || small(name) == each.also; });
        if (found == quantities.end()) {
            unknown.push_back(name);
            return;
        }
        auto& column = columns_[static_cast<std::size_t>(found - quantities.begin())];
        std::string const place = fmt::format("column {}", at + 1);
        if (!column.heading.empty()) {
            fault(line, place, std::string(heading), "this quantity has a column already, " + column.heading, "leave one of them out, or give it another name");
            return;
        }
        column.at = at;
        column.heading = heading;
        auto const close = heading.find_first_of("])");
        bool const has_unit = open != std::string_view::npos && close != std::string_view::npos && close > open;
        std::string const given = has_unit ? plain_unit(heading.substr(open + 1, close - open - 1)) : "";
        auto const unit = std::find_if(found->units.begin(), found->units.end(), [&](Unit const& each) { return each.name == given; });
        if (unit != found->units.end()) {
            column.factor = unit->factor;
        } else if (!has_unit && found->name == quantities[position].name) {
            column.factor = 1;
        } else {
            fault(line, place, std::string(heading), has_unit ? "the unit is not known" : "the unit is missing",
                  fmt::format("write {} {}", found->name, found->known_units));
        }
    }

    bool read_header(std::string_view text, int line)
    {
        separator_ = text.find(';') != std::string_view::npos ? ';' : text.find('\t') != std::string_view::npos ? '\t' : ',';
        auto const headings = fields_of(text, separator_);
        std::vector<std::string_view> unknown;
        for (std::size_t i = 0; i < headings.size(); ++i) {
            read_heading(headings[i], i, line, unknown);
        }
        bool const numbers = std::all_of(headings.begin(), headings.end(), [](std::string_view each) { return number_of(each).has_value(); });
        if (numbers) {
            fault(line, "header", std::string(text), "is missing: the file begins with numbers", how_to_begin);
            return false;
        }
        need_one(torque, current, line, unknown);
        need_one(angle, position, line, unknown);
        return result_.faults.empty();
    }

    /// One of two columns, not both.
    void need_one(std::size_t read, std::size_t computed, int line, std::vector<std::string_view> const& unknown)
    {
        auto const &a = columns_[read], &b = columns_[computed];
        std::string const names = fmt::format("\"{}\" or \"{}\"", quantities[read].name, quantities[computed].name);
        if (!a.heading.empty() && !b.heading.empty()) {
            fault(line, fmt::format("column {}", b.at + 1), b.heading, "both " + a.heading + " and " + b.heading + " are there, and they may disagree", "leave one of them out");
        } else if (a.heading.empty() && b.heading.empty()) {
            std::string remedy = how_to_begin;
            for (auto const name : unknown) {
                if (auto const meant = nearest(name, {quantities[read].name, quantities[computed].name, quantities[read].also, quantities[computed].also})) {
                    remedy = fmt::format("write {} in place of {}", *meant, name);
                    break;
                }
            }
            fault(line, "header", "", "there is no column " + names, remedy);
        }
    }

    /// What turns readings into torque and angle.
    void take_rig(RigOptions const& rig, double scene_ratio)
    {
        bool const has_current = !columns_[current].heading.empty(), has_counts = !columns_[position].heading.empty();
        need(has_current, "--torque-constant", "motor current", rig.torque_constant, "the motor's torque per current in N m/A, such as --torque-constant 0.119");
        need(has_counts, "--counts-per-turn", "encoder counts", rig.counts_per_turn, "the encoder's counts per turn of the motor, after multiplication, such as --counts-per-turn 2000");
        refuse_unused(has_current, "--efficiency", "motor current", rig.efficiency);
        refuse_unused(has_current || has_counts, "--ratio", "reading of the motor's side", rig.ratio);
        double const ratio = std::abs(rig.ratio.value_or(scene_ratio));
        double const constant = rig.torque_constant.value_or(0), counts = rig.counts_per_turn.value_or(0), efficiency = rig.efficiency.value_or(1);
        if (rig.efficiency && !(efficiency > 0 && efficiency <= 1)) {
            result_.faults.push_back({"--efficiency", 0, fmt::format("{:g}", efficiency), "is no share of a torque", "write a number above 0 and at most 1"});
        }
        if (rig.ratio && !(ratio > 0 && std::isfinite(ratio))) {
            result_.faults.push_back({"--ratio", 0, fmt::format("{:g}", *rig.ratio), "is no ratio of motor turns to output turns", "write a finite number other than 0"});
        }
        auto& curve = result_.curve;
        curve.rig = {has_current ? constant : 0, has_counts ? counts : 0, ratio, has_current ? efficiency : 1};
        curve.columns = columns_[has_current ? current : torque].heading + ", " + columns_[has_counts ? position : angle].heading;
        torque_column_ = columns_[has_current ? current : torque];
        angle_column_ = columns_[has_counts ? position : angle];
        torque_column_.factor *= has_current ? constant * ratio * efficiency * nmm_per_nm : 1;
        angle_column_.factor *= has_counts ? 2 * std::numbers::pi / (counts * ratio) : 1;
    }

    void need(bool used, char const* option, char const* what, std::optional<double> const& given, char const* remedy)
    {
        if (used && !given) {
            result_.faults.push_back({option, 0, "", fmt::format("is missing: {} has a column of {}", name_, what), fmt::format("write {}", remedy)});
        } else if (used && !(std::isfinite(*given) && *given != 0)) {
            result_.faults.push_back({option, 0, fmt::format("{:g}", *given), "must be finite and not 0", fmt::format("write {}", remedy)});
        } else {
            refuse_unused(used, option, what, given);
        }
    }

    void refuse_unused(bool used, char const* option, char const* what, std::optional<double> const& given)
    {
        if (!used && given) {
            result_.faults.push_back({option, 0, fmt::format("{:g}", *given), fmt::format("{} has no column that needs it: no {}", name_, what), "leave it out"});
        }
    }

    static std::optional<double> number_of(std::string_view field)
    {
        double value = 0;
        char const* const end = field.data() + field.size();
        if (field.starts_with('+')) {
            field.remove_prefix(1);
        }
        auto const [next, error] = std::from_chars(field.data(), end, value);
        return error == std::errc{} && next == end && std::isfinite(value) ? std::optional(value) : std::nullopt;
    }

    std::optional<double> value_of(Column const& column, std::vector<std::string_view> const& fields, int line)
    {
        std::string const place = fmt::format("column {}, {}", column.at + 1, column.heading);
        if (fields.size() <= column.at) {
            fault(line, place, "", fmt::format("is missing: the line has {} field{}", fields.size(), fields.size() == 1 ? "" : "s"), "write a number in every column");
            return std::nullopt;
        }
        auto const value = number_of(fields[column.at]);
        if (!value) {
            bool const comma = fields[column.at].find(',') != std::string_view::npos;
            fault(line, place, std::string(fields[column.at]), fields[column.at].empty() ? "is empty" : "is no finite number",
                  comma ? "write a point in place of the decimal comma" : "write a number such as 12.5");
        }
        return value;
    }

    /// False: enough has been seen.
    bool read_row(std::string_view text, int line)
    {
        auto& curve = result_.curve;
        auto const fields = fields_of(text, separator_);
        auto const moment = value_of(torque_column_, fields, line), turn = value_of(angle_column_, fields, line);
        if (moment && turn) {
            curve.torque.push_back(*moment * torque_column_.factor);
            curve.twist.push_back(*turn * angle_column_.factor);
            curve.line.push_back(line);
        }
        if (curve.line.size() > most_samples) {
            fault(0, "", "", fmt::format("holds more than {} samples", most_samples), "keep every tenth sample or so");
            return false;
        }
        constexpr std::size_t most_faults = 20;  // of one file: further ones are of the same sort
        return result_.faults.size() < most_faults;
    }

    std::filesystem::path const& file_;
    std::string name_;
    MeasuredReading& result_;
    std::ifstream in_;
    char separator_ = '\0';
    std::array<Column, quantities.size()> columns_;
    Column torque_column_, angle_column_;
};

}  // namespace

MeasuredReading examine_measured(std::filesystem::path const& file, RigOptions const& rig, double scene_ratio)
{
    MeasuredReading result;
    result.curve.file = file.string();
    Reader(file, result).read(rig, scene_ratio);
    return result;
}

}  // namespace hdconj
