// SPDX-License-Identifier: GPL-3.0-or-later
// The dimensions of a drive as rows, and the scene that they make.
#pragma once

#include <string_view>
#include <vector>

#include "hdconj/design.hpp"

namespace hdconj::design {

/// @p value with three significant digits, as a drawing has it.
[[nodiscard]] double rounded(double value, int digits = 3);
/// The least such value that is no smaller than @p value.
[[nodiscard]] double rounded_up(double value, int digits = 3);
[[nodiscard]] double rounded_down(double value, int digits = 3);

/// Dimensions so far; later rows take earlier ones by their symbols.
class Sheet
{
  public:
    Sheet() = default;
    explicit Sheet(std::vector<DesignRow> rows) : rows_(std::move(rows)) {}

    void add(DesignRow row) { rows_.push_back(std::move(row)); }
    [[nodiscard]] std::vector<DesignRow> const& rows() const { return rows_; }
    /// The value called @p symbol. @throws std::logic_error where there is none
    [[nodiscard]] double operator[](std::string_view symbol) const;

  private:
    std::vector<DesignRow> rows_;
};

/// The least of both with which load computes the coned cup; 0: nothing is known of a cone.
struct ConeNeed
{
    double clearance = 0;   ///< side clearance [mm]
    double tip_radius = 0;  ///< tip circle of the circular spline [mm]
};

/// The scene of the rows with a key, and of @p changes, which take the place of rows of the same key.
/// @throws InputError with every fault, those of geometry among them
[[nodiscard]] Scene scene_of(std::vector<DesignRow> const& rows, std::vector<DesignRow> const& changes = {});

/// What follows from the wishes alone: teeth, module, pitch diameter.
[[nodiscard]] Sheet drive_rows(DesignWishes const& wishes);
/// The tooth of the family that is asked for.
void add_tooth_rows(Sheet& sheet, DesignWishes const& wishes);
/// The body of flexspline, circular spline and bearing. @param wall  of the ring, over the pitch diameter
/// @param cone  what the circular spline has to leave the cup
void add_body_rows(Sheet& sheet, DesignWishes const& wishes, double wall, ConeNeed const& cone);

/// The bent cup and the slices with which the ring is checked, as loaded_scene() has them, and the torque, so that
/// every verb makes that ring. @param torque  [N mm]
void add_load_rows(Sheet& sheet, double torque);

}  // namespace hdconj::design
