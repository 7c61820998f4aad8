// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/measured.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "file/csv.hpp"
#include "file/listed_faults.hpp"
#include "hdconj/units.hpp"
#include "measured_columns.hpp"

namespace hdconj {
namespace {

using rig::MeasuredColumn;
using rig::MeasuredColumns;

Fault fault_of(file::Unreadable cause, std::string const& name)
{
    using enum file::Unreadable;
    if (cause == too_large)
        return rig::fault_of_file(name, fmt::format("is larger than {} MiB", largest_measured_file >> 20),
                                  "keep every tenth sample or so");
    return rig::fault_of_file(
        name,
        cause == is_folder    ? "is a folder"
        : cause == not_opened ? "cannot be read"
                              : "is no file that ends",
        cause == not_opened ? "write the name of a CSV file that is there" : "write the name of a CSV file");
}

/// An option that says something about the rig, and the column that needs it.
struct RigOption
{
    char const* name;
    std::optional<double> given;
    bool used;           ///< the file has the column
    char const* column;  ///< what that column holds
};

void refuse_unused(RigOption const& option, std::string const& file, Faults& faults)
{
    if (!option.used && option.given)
        faults.push_back({option.name, 0, fmt::format("{:g}", *option.given),
                          fmt::format("{} has no column that needs it: no {}", file, option.column), "leave it out"});
}

/// @param remedy  what to write where the option is missing
void require_number(RigOption const& option, char const* remedy, std::string const& file, Faults& faults)
{
    if (option.used && !option.given)
        faults.push_back({option.name, 0, "", fmt::format("is missing: {} has a column of {}", file, option.column),
                          fmt::format("write {}", remedy)});
    else if (option.used && !(std::isfinite(*option.given) && *option.given != 0))
        faults.push_back({option.name, 0, fmt::format("{:g}", *option.given), "must be finite and not 0",
                          fmt::format("write {}", remedy)});
    else
        refuse_unused(option, file, faults);
}

/// What of the rig turns the columns' readings into torque and angle at the output.
RigInputs rig_inputs(MeasuredColumns const& columns, RigOptions const& rig, double scene_ratio, std::string const& file,
                     Faults& faults)
{
    bool const has_current = columns.current.given(), has_counts = columns.position.given();
    require_number({"--torque-constant", rig.torque_constant, has_current, "motor current"},
                   "the motor's torque per current in N m/A, such as --torque-constant 0.119", file, faults);
    require_number({"--counts-per-turn", rig.counts_per_turn, has_counts, "encoder counts"},
                   "the encoder's counts per turn of the motor, after multiplication, such as --counts-per-turn 2000",
                   file, faults);
    refuse_unused({"--efficiency", rig.efficiency, has_current, "motor current"}, file, faults);
    refuse_unused({"--ratio", rig.ratio, has_current || has_counts, "reading of the motor's side"}, file, faults);
    double const ratio = std::abs(rig.ratio.value_or(scene_ratio)), efficiency = rig.efficiency.value_or(1);
    if (rig.efficiency && !(efficiency > 0 && efficiency <= 1))
        faults.push_back({"--efficiency", 0, fmt::format("{:g}", efficiency), "is no efficiency",
                          "write a number above 0 and at most 1"});
    if (rig.ratio && !(ratio > 0 && std::isfinite(ratio)))
        faults.push_back({"--ratio", 0, fmt::format("{:g}", *rig.ratio), "is no ratio of motor turns to output turns",
                          "write a finite number other than 0"});
    return {has_current ? rig.torque_constant.value_or(0) : 0, has_counts ? rig.counts_per_turn.value_or(0) : 0, ratio,
            has_current ? efficiency : 1};
}

/// The two columns of a curve, with the factors to N mm and rad at the output.
struct CurveColumns
{
    char separator;
    std::size_t count;
    MeasuredColumn torque, angle;
};

CurveColumns curve_columns(MeasuredColumns const& columns, RigInputs const& rig)
{
    bool const has_current = columns.current.given(), has_counts = columns.position.given();
    CurveColumns curve{columns.separator, columns.count, has_current ? columns.current : columns.torque,
                       has_counts ? columns.position : columns.angle};
    curve.torque.factor *= has_current ? rig.torque_constant * rig.ratio * rig.efficiency * newton_metre : 1;
    curve.angle.factor *= has_counts ? 2 * std::numbers::pi / (rig.counts_per_turn * rig.ratio) : 1;
    return curve;
}

std::optional<double> value_of(MeasuredColumn const& column, std::vector<std::string_view> const& fields, int line,
                               std::string const& file, Faults& faults)
{
    std::string const place = fmt::format("column {}, {}", column.at + 1, column.heading);
    if (fields.size() <= column.at) {
        faults.push_back(
            {place, line, "",
             fmt::format("is missing: the line has {} field{}", fields.size(), fields.size() == 1 ? "" : "s"),
             "write a number in every column", file});
        return std::nullopt;
    }
    std::string_view const field = fields[column.at];
    auto const value = file::number_in(field);
    if (!value)
        faults.push_back({place, line, std::string(field), field.empty() ? "is empty" : "is no finite number",
                          field.find(',') != std::string_view::npos ? "write a point in place of the decimal comma"
                                                                    : "write a number such as 12.5",
                          file});
    return value;
}

/// Adds the sample of one line. @returns whether to read on
bool read_row(CurveColumns const& columns, std::string_view text, int line, MeasuredReading& result)
{
    MeasuredCurve& curve = result.curve;
    auto const fields = file::fields_of(text, columns.separator);
    bool const has_more = std::any_of(fields.begin() + std::ptrdiff_t(std::min(columns.count, fields.size())),
                                      fields.end(), [](std::string_view each) { return !each.empty(); });
    if (has_more)
        result.faults.push_back({"line", line, "",
                                 fmt::format("has {} fields for {} columns", fields.size(), columns.count),
                                 "name every column in the first line, write decimals with a point, or separate the "
                                 "fields by semicolons",
                                 curve.file});
    auto const torque = value_of(columns.torque, fields, line, curve.file, result.faults);
    auto const angle = value_of(columns.angle, fields, line, curve.file, result.faults);
    if (torque && angle) {
        curve.torque.push_back(*torque * columns.torque.factor);
        curve.twist.push_back(*angle * columns.angle.factor);
        curve.line.push_back(line);
    }
    if (curve.line.size() > most_samples) {
        result.faults.push_back(rig::fault_of_file(curve.file, fmt::format("holds more than {} samples", most_samples),
                                                   "keep every tenth sample or so"));
        return false;
    }
    return true;
}

}  // namespace

MeasuredReading examine_measured(std::filesystem::path const& file, RigOptions const& rig, double scene_ratio)
{
    MeasuredReading result;
    result.curve.file = file.string();
    std::string const& name = result.curve.file;
    std::optional<CurveColumns> columns;
    bool header_seen = false;
    file::FurtherFaults further;
    auto const unreadable = file::read_csv(file, largest_measured_file, [&](std::string_view line, int number) {
        if (columns) {
            bool const more = read_row(*columns, line, number, result);
            further.take_from(result.faults);
            return more;
        }
        header_seen = true;
        MeasuredColumns const found = rig::measured_columns(file::trimmed(line), number, name, result.faults);
        if (!result.faults.empty())
            return false;
        result.curve.rig = rig_inputs(found, rig, scene_ratio, name, result.faults);
        columns = curve_columns(found, result.curve.rig);
        result.curve.columns = columns->torque.heading + ", " + columns->angle.heading;
        return true;
    });
    further.add_to(result.faults, name);
    if (unreadable)
        result.faults.push_back(fault_of(*unreadable, name));
    else if (!header_seen)
        result.faults.push_back(rig::fault_of_file(name, "has no header and no samples", rig::how_to_begin));
    return result;
}

MeasurementReading examine_measurement(std::filesystem::path const& file, RigOptions const& rig, OutputMember member,
                                       int flexspline_teeth, int circular_spline_teeth)
{
    bool const cup = member == OutputMember::cup;
    int const difference = circular_spline_teeth - flexspline_teeth;
    double const scene_ratio =
        difference != 0 && flexspline_teeth > 0
            ? std::abs(static_cast<double>(cup ? flexspline_teeth : circular_spline_teeth) / difference)
            : 1;
    auto reading = examine_measured(file, rig, scene_ratio);
    if (!reading.faults.empty())
        return {{}, std::move(reading.faults)};
    if (cup && flexspline_teeth > 0)
        reading.curve.rig.angle_per_spline = static_cast<double>(circular_spline_teeth) / flexspline_teeth;
    try {
        MeasuredStiffness const found = measured_stiffness(reading.curve);
        return {Measurement{std::move(reading.curve), found}, {}};
    } catch (InputError const& error) {
        return {{}, error.faults()};
    }
}

}  // namespace hdconj
