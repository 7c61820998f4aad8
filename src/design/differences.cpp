// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <set>
#include <string>

#include "base/text.hpp"
#include "base/toml_string.hpp"
#include "hdconj/design.hpp"
#include "hdconj/scene/schema.hpp"
#include "same_value.hpp"
#include "sheet.hpp"

namespace hdconj {
namespace {

std::string list_text(scene::NumberRows const& rows)
{
    std::string text;
    for (auto const& row : rows) {
        std::string inner;
        for (double const value : row)
            inner += (inner.empty() ? "" : ", ") + number_text(value);
        text += (text.empty() ? "[" : ", [") + inner + "]";
    }
    return "[" + text + "]";
}

/// Why @p design has no row for a key that a scene has.
std::string reason_for_absence(Design const& design, std::string const& path)
{
    if (path.ends_with("_ramp"))
        return "R_1 and R_2 are written as fillets, with which the largest stress converges";
    if (path.starts_with("wedm."))
        return "wire and spark gap are for the user to state";
    if (path == "load.torque" && !design.wishes.torque)
        return "no --torque is given";
    return "no rule gives it";
}

}  // namespace

namespace design {

bool same_value(std::string const& a, std::string const& b)
{
    auto const number_a = leading_number(a), number_b = leading_number(b);
    bool const numbers = number_a && number_b && number_a->rest.empty() && number_b->rest.empty();
    return numbers ? number_a->value == number_b->value : printable(a) == printable(b);
}

std::optional<std::string> standard_value(std::string const& path)
{
    for (auto const& table : scene::scene_schema())
        for (auto const& key : table.keys) {
            if (std::string(table.path) + "." + std::string(key.spec.key) != path || !key.standard)
                continue;
            DesignRow row;
            row.value = *key.standard;
            return row.written();
        }
    return std::nullopt;
}

}  // namespace design

std::string DesignRow::written() const
{
    if (auto const* const rows = std::get_if<scene::NumberRows>(&value))
        return list_text(*rows);
    if (auto const* const text = std::get_if<std::string>(&value))
        return toml_string(*text);
    return number_text(number());
}

DesignRange RangeRule::operator()(double value) const
{
    constexpr int digits = 6;
    return {design::rounded(shares.low * value + more.low, digits),
            design::rounded(shares.high * value + more.high, digits)};
}

std::string range_text(std::optional<DesignRange> const& range)
{
    constexpr int digits = 4;
    if (!range)
        return "";
    if (std::isinf(range->high))
        return ">= " + short_number(range->low, digits);
    return short_number(range->low, digits) + " ... " + short_number(range->high, digits);
}

bool is_like(Design const& design, Scene const& other)
{
    Drive const &a = design.scene.drive, &b = other.drive;
    return a.flexspline_teeth == b.flexspline_teeth && a.circular_spline_teeth == b.circular_spline_teeth &&
           a.module == b.module && design.scene.flexspline.profile.family == other.flexspline.profile.family;
}

std::vector<DesignDifference> differences(Design const& made, Scene const& other)
{
    std::vector<DesignDifference> found;
    std::set<std::string, std::less<>> ours;
    auto const is_standard = [](std::string const& path, std::string const& written) {
        auto const standard = design::standard_value(path);
        return standard && design::same_value(*standard, written);
    };
    for (auto const& row : made.rows) {
        ours.insert(row.key);
        auto const there = other.given.find(row.key);
        std::string const theirs = there == other.given.end() ? "" : there->second.written;
        bool const skipped = row.key.empty() || row.key == "drive.name" || design::same_value(row.written(), theirs);
        if (!skipped && !(theirs.empty() && is_standard(row.key, row.written())))
            found.push_back({row.key, row.written(), theirs,
                             row.rule + (row.range ? " = " + row.range_text() : "") +
                                 (row.remark.empty() ? "" : "; " + row.remark)});
    }
    for (auto const& [path, key] : other.given)
        if (!key.written.empty() && !ours.contains(path) && !is_standard(path, key.written))
            found.push_back({path, "", key.written, reason_for_absence(made, path)});
    return found;
}

}  // namespace hdconj
