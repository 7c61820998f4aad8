// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What all surfaces of a study are computed with.
#pragma once

#include "hdconj/numeric/tolerance.hpp"
#include "hdconj/pipeline/solution.hpp"
#include "spline_surface.hpp"
#include "stage_clock.hpp"

namespace hdconj::detail {

class PlaceCache;

/// What all cases of a study share.
struct ContactBench
{
    Scene const& scene;
    Profile const& tooth;
    AnyWaveShape const& shape;
    PairGeometry const& geometry;
    SurfaceMaker& maker;
    ContactRequest request;
    int threads = 1;
    double width = 0;        ///< [mm]
    Tolerance tolerance;
    StageClock& clock;
    PlaceCache& places;
    BentCup const* cup = nullptr;  ///< null: the linear cone, or none
};

}  // namespace hdconj::detail
