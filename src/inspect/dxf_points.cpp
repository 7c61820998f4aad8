// SPDX-License-Identifier: GPL-3.0-or-later
#include "dxf_points.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <map>
#include <string>
#include <string_view>

#include "base/text.hpp"
#include "file/dxf_groups.hpp"
#include "file/listed_faults.hpp"
#include "hdconj/units.hpp"

namespace hdconj::inspect {
namespace {

constexpr int code_elevation = 38;  // of a LWPOLYLINE

/// mm of a unit of $INSUNITS; nothing for one that no drawing of a gear has.
std::optional<double> unit_of_drawing(double number)
{
    constexpr double inch = 25.4, centimetre = 10, metre = 1000;
    constexpr int of_none = 0, of_inch = 1, of_mm = 4, of_cm = 5, of_m = 6, of_um = 13;
    switch (static_cast<int>(number)) {
        case of_none:
        case of_mm:
            return 1;
        case of_inch:
            return inch;
        case of_cm:
            return centimetre;
        case of_m:
            return metre;
        case of_um:
            return um;
        default:
            return std::nullopt;
    }
}

/// Reads the groups one by one.
class DxfPoints
{
  public:
    explicit DxfPoints(PointReading& result) : result_(result) {}

    /// One group: its code, its value, and the line of the value. @returns whether to read on
    bool take(int code, std::string_view value, int line)
    {
        using namespace file::dxf;
        if (code == code_type) {
            end_entity();
            if (value != "VERTEX")  // which is of the layer of its polyline where it names none
                layer_ = "0";
            entity_ = value;
            line_ = line;
        } else if (code == code_name && entity_ == "SECTION") {
            in_entities_ = value == "ENTITIES";
        } else if (code == code_variable) {
            variable_ = value;
        } else if (code == code_flags && variable_ == "$INSUNITS") {
            set_unit(value, line);
            variable_.clear();
        } else if (in_entities_ && code == code_layer) {
            layer_ = value.empty() ? "0" : value;
        } else if (in_entities_ && (entity_ == "POINT" || entity_ == "VERTEX" || entity_ == "LWPOLYLINE")) {
            take_coordinate(code, value, line);
        }
        further_.take_from(result_.faults);
        return result_.measured.points.size() <= most_part_points;
    }
    /// After the last group.
    void end()
    {
        if (result_.faults.empty())
            end_point();
        further_.add_to(result_.faults, result_.measured.file);
    }

  private:
    void fault(int line, std::string_view value, std::string reason, std::string remedy)
    {
        result_.faults.push_back(
            {"DXF", line, printable(value), std::move(reason), std::move(remedy), result_.measured.file});
    }
    void set_unit(std::string_view value, int line)
    {
        auto const number = file::number_in(value);
        auto const factor = number && std::abs(*number) < farthest ? unit_of_drawing(*number) : std::nullopt;
        if (factor)
            factor_ = *factor;
        else
            fault(line, value, "is no $INSUNITS of a gear", "save the drawing in mm");
    }
    void take_coordinate(int code, std::string_view value, int line)
    {
        using namespace file::dxf;
        if (code != code_x && code != code_y && code != code_z && code != code_elevation)
            return;
        auto const number = file::number_in(value);
        if (!number || std::abs(*number * factor_) > farthest) {
            fault(line, value, number ? "is no coordinate of a gear" : "is no finite number",
                  "save the drawing again, in mm");
            return;
        }
        double const length = *number * factor_;
        if (code == code_x) {
            end_point();
            point_ = PartPoint{Vec2(length, 0), elevation_, 0, std::nullopt, line_, number_of_layer()};
        } else if (code == code_elevation) {
            elevation_ = length;
        } else if (point_) {
            (code == code_y ? point_->where.y() : point_->z) = length;
        }
    }
    std::size_t number_of_layer()
    {
        auto const [found, is_new] = layers_.emplace(layer_, layers_.size());
        if (is_new)
            result_.measured.layers.emplace_back(printable(layer_));
        return found->second;
    }
    void end_entity()
    {
        end_point();
        elevation_ = 0;
    }
    void end_point()
    {
        if (!point_)
            return;
        result_.measured.has_z = result_.measured.has_z || point_->z != 0;
        result_.measured.points.push_back(*point_);
        point_.reset();
    }

    PointReading& result_;
    file::FurtherFaults further_;
    std::string entity_, variable_, layer_ = "0";
    std::map<std::string, std::size_t> layers_;
    bool in_entities_ = false;
    double factor_ = 1, elevation_ = 0;
    int line_ = 0;
    std::optional<PartPoint> point_;
};

}  // namespace

std::optional<file::Unreadable> read_dxf_points(std::filesystem::path const& file, PointReading& result)
{
    DxfPoints points(result);
    std::optional<int> code;
    auto const unreadable = file::read_lines(file, largest_point_file, [&](std::string_view line, int number) {
        std::string_view const text = file::trimmed(line, " \t\r\n");
        if (code) {
            bool const more = points.take(*code, text, number);
            code.reset();
            return more;
        }
        int value = 0;
        auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error == std::errc{} && end == text.data() + text.size()) {
            code = value;
            return true;
        }
        result.faults.push_back({"DXF", number, printable(text), "is no group code: every second line of a DXF is one",
                                 "save the drawing as DXF text (ASCII)", result.measured.file});
        return false;
    });
    if (!unreadable)
        points.end();
    return unreadable;
}

}  // namespace hdconj::inspect
