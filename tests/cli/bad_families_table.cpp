// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bad_families_table.hpp"

namespace hdconj::test {

std::vector<BadFamily> const& bad_families()
{
    std::string const tooth = "flexspline.profile";
    std::string const points = tooth + ".points";
    std::string const pieces = tooth + ".pieces";
    std::string const bezier_points = "points = [[0.06, 0.2], [0.15, 0.12], [0.17, -0.04], [0.29, -0.28]]";
    static std::vector<BadFamily> const rows{
        // straight
        {"straight", {"straight: flanks that cross", "thickness = 0.39", "thickness = 0.2", tooth + ".addendum", "cross below the tip", "at most 0.18"}},
        {"straight", {"straight: angle beyond range", "pressure_angle_deg = 29", "pressure_angle_deg = 61", tooth + ".pressure_angle_deg", "at most 60", "from 0 to 60"}},
        {"straight", {"straight: no thickness", "thickness = 0.39", "", tooth + ".thickness", "missing", "thickness"}},
        {"straight", {"straight: wider than its pitch", "thickness = 0.39", "thickness = 0.7", tooth, "wider than its pitch", "thinner"}},
        // points
        {"points", {"points: no file", "file = \"points-flank.csv\"", "file = \"none.csv\"", tooth + ".file", "cannot be read", "CSV"}},
        {"points", {"points: empty file name", "file = \"points-flank.csv\"", "file = \"\"", tooth + ".file", "empty", "file name"}},
        {"points", {"points: unknown side", "side = \"right\"", "side = \"left\"", tooth + ".side", "unknown word", "\"full\""}},
        {"points", {"points: a flank is no whole tooth", "side = \"right\"", "side = 1", tooth + ".side", "a number where a word", "\"right\""}},
        // involute
        {"involute", {"involute: pointed", "addendum = 0.2", "addendum = 0.35", tooth + ".addendum", "becomes pointed at height 0.34", "at most 0.34"}},
        {"involute", {"involute: pointed by thickness", "thickness = 0.38", "thickness = 0.1", tooth + ".addendum", "becomes pointed", "larger thickness"}},
        {"involute", {"involute: thickness of a pitch", "thickness = 0.38", "thickness = 0.79", tooth + ".thickness", "no space", "half the pitch"}},
        {"involute", {"involute: no pressure angle", "pressure_angle_deg = 28.6", "pressure_angle_deg = 0", tooth + ".pressure_angle_deg", "at least 1", "from 1 to 60"}},
        {"involute", {"involute: pressure angle of 90", "pressure_angle_deg = 28.6", "pressure_angle_deg = 90", tooth + ".pressure_angle_deg", "at most 60", "from 1 to 60"}},
        {"involute", {"involute: nan", "addendum = 0.2", "addendum = nan", tooth + ".addendum", "finite", "length"}},
        {"involute", {"involute: list for a length", "addendum = 0.2", "addendum = [0.2]", tooth + ".addendum", "a list where", "length"}},
        // cycloid
        {"cycloid", {"cycloid: rolling circle too small", "addendum_rolling_radius = 0.14", "addendum_rolling_radius = 0.09", tooth + ".addendum_rolling_radius", "not the tip", "half the addendum"}},
        {"cycloid", {"cycloid: lower rolling circle too small", "dedendum_rolling_radius = 0.2", "dedendum_rolling_radius = 0.12", tooth + ".dedendum_rolling_radius", "not the root", "half the dedendum"}},
        {"cycloid", {"cycloid: both too small", "addendum_rolling_radius = 0.14\ndedendum_rolling_radius = 0.2", "addendum_rolling_radius = 0.09\ndedendum_rolling_radius = 0.12", tooth + ".dedendum_rolling_radius", "not the root", "half the dedendum", 2}},
        {"cycloid", {"cycloid: undercut", "dedendum_rolling_radius = 0.2", "dedendum_rolling_radius = 12.6", tooth + ".dedendum_rolling_radius", "undercut", "at most 12.5"}},
        {"cycloid", {"cycloid: pointed", "thickness = 0.39", "thickness = 0.2", tooth + ".addendum", "becomes pointed", "larger thickness"}},
        {"cycloid", {"cycloid: thickness of a pitch", "thickness = 0.39", "thickness = 0.8", tooth + ".thickness", "no space", "half the pitch"}},
        {"cycloid", {"cycloid: zero radius", "addendum_rolling_radius = 0.14", "addendum_rolling_radius = 0", tooth + ".addendum_rolling_radius", "above 0", "length"}},
        // s-tooth
        {"s-tooth", {"s-tooth: addendum above the locus", "addendum = 0.19", "addendum = 0.23", tooth + ".addendum", "the locus ends at height 0.22", "smaller addendum"}},
        {"s-tooth", {"s-tooth: cusp", "pressure_angle_deg = 9", "pressure_angle_deg = 0", tooth + ".pressure_angle_deg", "cusp", "pressure_angle_deg = 1"}},
        {"s-tooth", {"s-tooth: angle left out without deviation", "pressure_angle_deg = 9\n", "", tooth + ".pressure_angle_deg", "cusp", "pressure_angle_deg = 1"}},
        {"s-tooth", {"s-tooth: deflection too small", "deflection = 1.0", "deflection = 0.1", tooth + ".deflection", "at least 0.2", "from 0.2 to 1.5"}},
        {"s-tooth", {"s-tooth: deflection in quotes", "deflection = 1.0", "deflection = \"1.0\"", tooth + ".deflection", "text where a number", "without quotes"}},
        {"s-tooth", {"s-tooth: datum above the tip", "deflection = 1.0", "datum_rise = 0.19\ndeflection = 1.0", tooth + ".datum_rise", "between tip and root", "0.19"}},
        {"s-tooth", {"s-tooth: pointed", "thickness = 0.39", "thickness = 0.1", tooth + ".addendum", "becomes pointed", "larger thickness"}},
        {"s-tooth-deviated", {"s-tooth: no point has the angle", "deflection = 0.8", "pressure_angle_deg = 20\ndeflection = 0.8", tooth + ".pressure_angle_deg", "the least for this deflection is 20.5", "leave the key out"}},
        // arc-chain
        {"arc-chain", {"arc-chain: no pieces", "pieces = [", "peaces = [", tooth + ".peaces", "unknown key", "pieces"}},
        {"arc-chain", {"arc-chain: does not reach the root", "[-0.5, 60.0]", "[-0.5, 30.0]", pieces, "row 4 is the last and ends at height", "longer last piece"}},
        {"arc-chain", {"arc-chain: rows below the root", "[0.06]", "[0.6]", pieces, "row 3 goes below the root", "leave out"}},
        {"arc-chain", {"arc-chain: negative sweep", "[0.35, 9.0]", "[0.35, -9.0]", pieces, "row 2 has a sweep of -9", "sign of the radius"}},
        {"arc-chain", {"arc-chain: zero radius", "[0.35, 9.0]", "[0, 9.0]", pieces, "row 2: radius must not be 0", "[radius, sweep_deg]"}},
        {"arc-chain", {"arc-chain: negative length", "[0.06]", "[-0.06]", pieces, "row 3: length must not be negative", "[length]"}},
        {"arc-chain", {"arc-chain: three numbers", "[0.35, 9.0]", "[0.35, 9.0, 1.0]", pieces, "row 2 has 3 numbers", "[length] or [radius, sweep_deg]"}},
        {"arc-chain", {"arc-chain: an empty row", "[0.06]", "[]", pieces, "row 3 has 0 numbers", "[length]"}},
        {"arc-chain", {"arc-chain: a row without brackets", "[0.06]", "0.06", pieces, "row 3 is no list", "[length]"}},
        {"arc-chain", {"arc-chain: infinite radius", "[0.35, 9.0]", "[inf, 9.0]", pieces, "row 2: radius is not a finite number", "in mm and degrees"}},
        {"arc-chain", {"arc-chain: word in a row", "[0.35, 9.0]", "[\"wide\", 9.0]", pieces, "row 2: radius is no number", "[radius"}},
        {"arc-chain", {"arc-chain: two bad numbers are two faults", "[0.35, 9.0]", "[nan, true]", pieces, "row 2: radius", "[radius", 2}},
        {"arc-chain", {"arc-chain: rises above the tip", "tip_angle_deg = 38", "tip_angle_deg = -61", tooth + ".tip_angle_deg", "at least -60", "from -60 to 90"}},
        {"arc-chain", {"arc-chain: over the centre line", "tip_thickness = 0.2\ntip_angle_deg = 38", "tip_thickness = 0.0\ntip_angle_deg = 0", pieces, "", "", 0}},
        {"arc-chain", {"arc-chain: negative thickness", "tip_thickness = 0.2", "tip_thickness = -0.2", tooth + ".tip_thickness", "not be negative", "0 or more"}},
        // bezier
        {"bezier", {"bezier: one point", bezier_points, "points = [[0.06, 0.2]]", points, "has 1 row", "at least 2 [x, y]"}},
        {"bezier", {"bezier: number for a list", bezier_points, "points = 3", points, "a number where a list", "[x, y]"}},
        {"bezier", {"bezier: text for a list", bezier_points, "points = \"flank.csv\"", points, "text where a list", "[x, y]"}},
        {"bezier", {"bezier: a flat list", bezier_points, "points = [0.06, 0.2]", points, "row 1 is no list", "[x, y]", 2}},
        {"bezier", {"bezier: degree that does not fit", bezier_points, bezier_points + "\ndegree = 2", points, "no whole number of curves of degree 2", "write 3 or 5 points"}},
        {"bezier", {"bezier: degree zero", bezier_points, bezier_points + "\ndegree = 0", tooth + ".degree", "at least 1", "from 1 to 12"}},
        {"bezier", {"bezier: degree above the largest", bezier_points, bezier_points + "\ndegree = 13", tooth + ".degree", "at most 12", "from 1 to 12"}},
        {"bezier", {"bezier: too many points for one curve", bezier_points, "points = [[0.06,0.2],[0.07,0.19],[0.08,0.18],[0.09,0.17],[0.1,0.16],[0.11,0.1],[0.12,0.05],[0.13,0],[0.14,-0.05],[0.15,-0.1],[0.16,-0.15],[0.17,-0.2],[0.18,-0.25],[0.19,-0.28]]", points, "degree 13, above 12", "degree = 3"}},
        {"bezier", {"bezier: upside down", bezier_points, "points = [[0.29, -0.28], [0.17, -0.04], [0.15, 0.12], [0.06, 0.2]]", points, "does not cross the pitch line", "from tip to root"}},
        {"bezier", {"bezier: all above the pitch line", bezier_points, "points = [[0.06, 0.4], [0.15, 0.3], [0.17, 0.2], [0.29, 0.1]]", points, "does not cross the pitch line", "pitch line"}},
        {"bezier", {"bezier: first two points on each other", bezier_points, "points = [[0.06, 0.2], [0.06, 0.2], [0.17, -0.04], [0.29, -0.28]]", points, "no tangent at (0.06, 0.2)", "apart"}},
        {"bezier", {"bezier: all points on each other but the last", bezier_points, "points = [[0.1, 0.2], [0.1, 0.2]]", points, "", "", 0}},
        {"bezier", {"bezier: cusp", bezier_points, "points = [[0.06, 0.2], [0.3, -0.3], [0.3, 0.22], [0.06, -0.28]]", points, "", "", 0}},
        {"bezier", {"bezier: loop", bezier_points, "points = [[0.06, 0.2], [0.8, -0.3], [-0.4, -0.3], [0.29, -0.28]]", points, "", "", 0}},
        {"bezier", {"bezier: over the centre line", bezier_points, "points = [[0.06, 0.2], [-0.4, 0.12], [0.17, -0.04], [0.29, -0.28]]", points, "centre line", "x of 0 or more"}},
        {"bezier", {"bezier: above its tip", bezier_points, "points = [[0.06, 0.2], [0.15, 0.5], [0.17, -0.04], [0.29, -0.28]]", points, "rises above its tip", "highest point"}},
        {"bezier", {"bezier: below its root", bezier_points, "points = [[0.06, 0.2], [0.15, 0.12], [0.17, -0.74], [0.29, -0.28]]", points, "falls below its root", "lowest point"}},
        {"bezier", {"bezier: point in kilometres", bezier_points, "points = [[0.06, 0.2], [1e7, 0.12], [0.17, -0.04], [0.29, -0.28]]", points, "row 2: x is larger than any drive", "[x, y]"}},
        // b-spline
        {"b-spline", {"b-spline: repeated point", "[0.172, 0.000]", "[0.152, 0.060]", points, "row 4 repeats", "remove"}},
        {"b-spline", {"b-spline: bad rows are named each", "[0.172, 0.000]", "[0.172, nan], [0.18], [\"a\", 1979-05-27]", points, "row 4: y is not a finite number", "[x, y]", 4}},
        {"b-spline", {"b-spline: unknown side", "family = \"b-spline\"", "family = \"b-spline\"\nside = \"both\"", tooth + ".side", "unknown word", "\"full\""}},
        {"b-spline", {"b-spline: left of the centre line", "[0.070, 0.200]", "[-0.070, 0.200]", points, "left of the tooth's centre line", "side = \"full\""}},
        {"b-spline", {"b-spline: family misspelt", "family = \"b-spline\"", "family = \"bspline\"", tooth + ".family", "unknown word", "\"b-spline\""}},
        // a wave generator with breaks has no series
        {"four-roller", {"four-roller: material motion", "kinematics = \"exact\"", "kinematics = \"material\"", "solver.kinematics", "\"four-roller\" has angles where the third derivative", "write \"exact\""}},
        {"two-disc", {"two-disc: material motion", "kinematics = \"exact\"", "kinematics = \"material\"", "solver.kinematics", "\"two-disc\" has angles where the third derivative", "write \"exact\""}},
        {"cam-table", {"cam-table: material motion", "kinematics = \"exact\"", "kinematics = \"material\"", "solver.kinematics", "\"table\" has angles where the third derivative", "write \"exact\""}},
    };
    return rows;
}

}  // namespace hdconj::test
