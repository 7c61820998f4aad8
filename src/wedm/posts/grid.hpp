// SPDX-License-Identifier: GPL-3.0-or-later
// Coordinates as whole units of the last digit, and the block list that every dialect writes.
//
// Rounding is of absolute coordinates; differences are differences of rounded ones, so that no sum of them drifts.
// Whole numbers print without exponent and without negative zero in any locale.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hdconj/error.hpp"
#include "hdconj/wedm.hpp"

namespace hdconj::wedm {

/// The failure of a program that a dialect cannot hold: a block that its grid loses, or more blocks than its
/// controllers take.
[[nodiscard]] inline NumericalError no_room(std::string place, std::string cause)
{
    return {ErrorCode::no_room, "wire files", std::move(place), std::move(cause)};
}

/// A point in units of the last digit.
struct UnitPoint
{
    long long x = 0, y = 0;

    friend bool operator==(UnitPoint const&, UnitPoint const&) = default;
    friend UnitPoint operator-(UnitPoint const& a, UnitPoint const& b) { return {a.x - b.x, a.y - b.y}; }
};

/// The grid of all multiples of 10^-decimals mm.
class WireGrid
{
  public:
    explicit WireGrid(int decimals);

    /// Length of one unit [mm].
    [[nodiscard]] double unit() const { return 1 / static_cast<double>(scale_); }
    /// Nearest units. @throws NumericalError beyond 1 km or where not finite
    [[nodiscard]] long long units(double mm) const;
    [[nodiscard]] UnitPoint units(Vec2 const& point) const { return {units(point.x()), units(point.y())}; }
    /// Appends @p word and the number in mm, all decimals written.
    void put(std::string& text, std::string_view word, long long units) const;
    /// The same of a point.
    void put(std::string& text, std::string_view x, std::string_view y, UnitPoint const& point) const
    {
        put(text, x, point.x);
        put(text, y, point.y);
    }

  private:
    int decimals_;
    long long scale_ = 1;
};

/// The two planes that a dialect gives coordinates in.
enum class WirePlanes
{
    faces,
    guides
};

struct WireBlock
{
    UnitPoint lower, upper;
    WireTag tag = WireTag::contour;
};

/// The moves of a pass on @p grid, coordinates from @p origin.
/// @throws NumericalError with ErrorCode::no_room where a block has no length in one of the planes once it is rounded:
/// controllers refuse or misread it; NumericalError where it has none at all
[[nodiscard]] std::vector<WireBlock> blocks_of(WireProgram const& program, WirePass const& pass, WirePlanes planes,
                                               WireGrid const& grid, Vec2 const& origin = Vec2::Zero());

}  // namespace hdconj::wedm
