// SPDX-License-Identifier: GPL-3.0-or-later
// Distances as they are seen along the wire.
#pragma once

#include "hdconj/base/vec2.hpp"
#include "lean.hpp"
#include "region/segment_tree.hpp"

namespace hdconj::wedm {

/// Distance of @p p from the nearest segment of @p line, as it is seen along @p lean [mm].
[[nodiscard]] double seen_distance(region::SegmentTree const& line, Vec2 const& p, Lean const& lean = {});

}  // namespace hdconj::wedm
