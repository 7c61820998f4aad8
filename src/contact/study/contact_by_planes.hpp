// SPDX-License-Identifier: GPL-3.0-or-later
// The contact area of a pair that is conjugate in every plane, by another path than contact(): what that one is
// measured against.
#pragma once

#include <vector>

#include "hdconj/scene.hpp"

namespace hdconj::contact {

/// The area from so many planes.
struct PlaneSum
{
    int planes = 0;
    double area = 0;  ///< [mm^2]
};

/// Sums over nested planes, the coarsest first, and what the finest leaves open.
struct AreaByPlanes
{
    std::vector<PlaneSum> sums;  ///< of 3, 5, 9 ... planes
    double across = 0;           ///< estimated error of so many planes [mm^2]
    double along = 0;  ///< estimated error in the planes: what every second station in place of all changes [mm^2]

    [[nodiscard]] double area() const { return sums.back().area; }
    [[nodiscard]] double error() const { return across + along; }
};

/// A = int L(z) dz over the face width of surface "per-slice" without side clearance, on the driving side, at the
/// scene's angle of the wave generator.
///
/// L(z) is the length of all flanks in the plane z whose gap is within contact.contact_gap, times what they lean
/// (area_per_length()). Each plane has the conjugate outline of its own motion, and the edges of contact are roots of
/// the exact gap along it. Conjugate flanks touch without a turn.
///
/// The integral is the trapezoidal rule. In a space contact begins and ends along z like a square root or a straight
/// line, so that the rule's error falls by 2^1.5 or 4 when planes double. With D_0, D_1, D_2 the last three differences
/// of sums, from the finest on, d = max(|D_0|, |D_1|/2^1.5, |D_2|/8) and all further differences add up to less than
/// d/(2^1.5 - 1); twice that is `across`: right from 33 planes on.
/// @param planes  2^n + 1, n >= 3
/// Same bits for any number of threads.
/// @throws InputError for a scene without face width, with a side clearance or with teeth that are solved for;
/// NumericalError with stage, place and cause
[[nodiscard]] AreaByPlanes contact_by_planes(Scene const& scene, int planes);

}  // namespace hdconj::contact
