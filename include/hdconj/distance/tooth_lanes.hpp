// SPDX-License-Identifier: GPL-3.0-or-later
// Signed distances of several neighbouring points from a tooth of arcs and lines at once.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "hdconj/base/rigid_motion.hpp"
#include "hdconj/profile/profile.hpp"

namespace hdconj::distance {

/// Points that are evaluated together; one number each.
inline constexpr std::size_t lanes = 8;
struct alignas(lanes * sizeof(double)) Lanes : std::array<double, lanes>
{
};

/// The distances of ToothDistance for as many points at once as there are lanes. The loop has no branches, so that a
/// compiler makes vector instructions of it. Which ones is chosen when the program is loaded; all give the same bits.
///
/// Every arc and line is evaluated, prolonged beyond its ends by 2^-40 of its length, so that no joint is left out. Of
/// the joints only corners and root ends are evaluated. Accuracy: that of ToothDistance, but for 2^-40 of a piece; it
/// serves to tell where to look closer.
class ToothLanes
{
  public:
    /// At one position of the tooth: @p distance [mm] and @p slope, its derivative, of the points @p x, @p y.
    void operator()(Pose const& pose, PlanarVelocity const& twist, Lanes const& x, Lanes const& y, Lanes& distance,
                    Lanes& slope) const;

    struct Vertex
    {
        double x, y, n_x, n_y;  ///< with the mean of the normals on both sides
        double open_end;        ///< 1: root end of the profile
    };
    struct Line
    {
        double x, y, t_x, t_y;
        double from, to;  ///< along the tangent
    };
    struct Arc
    {
        double x, y, radius, side;
        double m_x, m_y;  ///< middle of the normals
        double cos_half_span;
    };
    /// The tooth.
    struct Features
    {
        std::vector<Vertex> vertices;
        std::vector<Line> lines;
        std::vector<Arc> arcs;
    };

  private:
    friend std::optional<ToothLanes> tooth_lanes(profile::Profile const& profile);

    Features features_;
};

/// Nothing where @p profile has a piece that is neither arc nor line, or so many that boxes about them (ToothDistance)
/// are the better way.
[[nodiscard]] std::optional<ToothLanes> tooth_lanes(profile::Profile const& profile);

}  // namespace hdconj::distance
