// SPDX-License-Identifier: GPL-3.0-or-later
// Measured points read against the nominal part.
#pragma once

#include <cstddef>
#include <vector>

#include "hdconj/inspect.hpp"
#include "nominal_part.hpp"

namespace hdconj::inspect {

/// Errors of all flanks that a registration knows beside the placement, as far as its points tell them apart.
enum class CommonErrorsKnown
{
    all,        ///< thickness, and slope and crowning of either side
    thickness,  ///< alone
    none
};

/// Where the measured part lies: its nominal point x is at R x + shift, R a clockwise turn.
struct Placement
{
    double turn = 0;            ///< [rad]
    Vec2 shift = Vec2::Zero();  ///< [mm]
    double excess = 0;          ///< by which right flanks are turned further, left ones less [rad]
    CommonErrorsKnown known = CommonErrorsKnown::none;
};

/// A point to be read: of which plane, and of which flank where that is known.
struct PlanePoint
{
    Vec2 where = Vec2::Zero();
    std::size_t plane = 0;      ///< index into NominalPart::planes
    std::optional<bool> right;  ///< which flank
    double above = 0;           ///< the height of that plane
};

/// A point as the nominal part sees it.
struct PointView
{
    bool on = false;             ///< whether its foot is on a flank
    std::size_t plane = 0;       ///< of the point
    int tooth = 0;               ///< from 0 clockwise
    bool right = false;          ///< which flank
    double deviation = 0;        ///< [mm]
    Vec2 foot = Vec2::Zero();    ///< frame of the tooth
    Vec2 normal = Vec2::Zero();  ///< out of the material; frame of the part
    Vec2 place = Vec2::Zero();   ///< of the point; frame of the part

    /// Change of the deviation with a clockwise turn of the part [mm/rad].
    [[nodiscard]] double by_turn() const { return normal.dot(left_of(place)); }
};

/// Reads points of a part that a probe of radius @p probe [mm] has measured.
class PointReader
{
  public:
    PointReader(NominalPart const& part, double probe);

    /// On the nearer flank of the tooth next to it.
    [[nodiscard]] PointView operator()(PlanePoint const& point, Placement const& placement) const;
    /// On the given flank of the given tooth.
    [[nodiscard]] PointView on_flank(PlanePoint const& point, Placement const& placement, int tooth, bool right) const;

    [[nodiscard]] NominalPart const& part() const { return part_; }
    /// @p v of the frame of a tooth in that of the part, a vector.
    [[nodiscard]] Vec2 from_tooth(Vec2 const& v, int tooth) const;
    /// The contrary.
    [[nodiscard]] Vec2 to_tooth(Vec2 const& v, int tooth) const;

  private:
    NominalPart const& part_;
    double probe_;
    std::vector<Vec2> turns_;  ///< cosine and sine of the angle of each tooth
};

/// The change of a deviation with a shift of the part, at the turn of @p placement.
[[nodiscard]] Vec2 by_shift(PointView const& view, Placement const& placement);

/// Every point, by threads. @p threads  0: all cores
[[nodiscard]] std::vector<PointView> views_of(PointReader const& read, std::vector<PlanePoint> const& points,
                                              Placement const& placement, int threads);

}  // namespace hdconj::inspect
