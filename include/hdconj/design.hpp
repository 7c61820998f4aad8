// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// `design`: from a few wishes to a whole scene, by the thesis' rules and by computation.
/// Lengths in mm, torques in N mm, stresses in MPa.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "hdconj/error.hpp"
#include "hdconj/judgement.hpp"
#include "hdconj/scene.hpp"
#include "hdconj/scene/parameters.hpp"
#include "hdconj/solution.hpp"

namespace hdconj {

/// What a designer asks for.
struct DesignWishes
{
    double ratio = 100;                          ///< i = z_f/(z_c - z_f), circular spline held; a whole number
    std::optional<double> diameter;              ///< pitch diameter d_r = m z_f of the flexspline [mm]
    std::optional<double> module;                ///< m [mm]; default the standard one nearest to diameter/z_f
    double length_ratio = 0.25;                  ///< cup length over pitch diameter
    std::optional<double> torque;                ///< rated torque on the circular spline [N mm]; default none
    std::string family = "double-circular-arc";  ///< of the flexspline's tooth
    std::string material = "30CrMnSiA";          ///< of the flexspline; any name where all three figures are given
    std::optional<double> fatigue;               ///< of the flexspline's steel, alternating bending [MPa]
    std::optional<double> youngs_modulus;        ///< of the flexspline's steel [MPa]
    std::optional<double> poissons_ratio;        ///< of the flexspline's steel
    double land = 0.4;                           ///< least tip land of either member, in modules
    double clearance = 0;                        ///< least side clearance of each flank [mm]
    double safety = 1.2;                         ///< least fatigue strength over largest stress
    std::string name = "designed";               ///< of the drive
};

/// Where the value of a row comes from.
enum class DesignOrigin
{
    wish,        ///< asked for
    rule,        ///< a rule, inside its range
    limited,     ///< a rule whose range the wishes do not allow: the remark says why
    computed,    ///< the search for the mesh, or for the wall
    assumption,  ///< nothing gives it
    figure       ///< a result that was computed with the scene
};
/// Words of DesignOrigin.
template <>
inline constexpr std::array<std::string_view, 6> words_of<DesignOrigin>{"wish",     "rule",       "limited",
                                                                        "computed", "assumption", "figure"};

/// A range as shares of another dimension.
struct RangeRule
{
    std::string base;        ///< symbol of the row of that dimension
    DesignRange shares;      ///< of it
    DesignRange more{0, 0};  ///< is added to them, in the unit of the row

    /// The range where the other dimension has the value @p value.
    [[nodiscard]] DesignRange operator()(double value) const;
};

/// "0.5 ... 0.75", ">= 70" or "".
[[nodiscard]] std::string range_text(std::optional<DesignRange> const& range);

/// One dimension of the drive: a row of the printed table, and where it has a key a line of the scene.
struct DesignRow
{
    std::string name;                          ///< in words
    std::string symbol;                        ///< may be empty
    std::string key;                           ///< path in the scene; empty: the scene has no such key
    std::string rule;                          ///< as text, "(0.01 ... 0.015) d_r"
    std::optional<DesignRange> range;          ///< that the rule gives; none: the rule is an equation
    scene::ParameterValue value;               ///< as the scene holds it
    std::string unit;                          ///< "mm", "N m", "MPa", "1"
    std::string source;                        ///< of the rule
    DesignOrigin origin = DesignOrigin::rule;  ///< of the value
    std::string remark;                        ///< may be empty
    std::optional<RangeRule> range_rule = {};  ///< that makes the range; none: no other dimension changes it

    /// The value as it stands in the scene, text in quotes.
    [[nodiscard]] std::string written() const;
    /// The range as range_text() writes it.
    [[nodiscard]] std::string range_text() const { return hdconj::range_text(range); }
    /// The value as a number. @pre it is one
    [[nodiscard]] double number() const { return std::get<double>(value); }
};

/// A radial deformation that the search tried, with the least tip circle that suits it.
struct MeshTrial
{
    double ratio = 0;          ///< 2 w0/(m (z_c - z_f))
    double w0 = 0;             ///< radial deformation [mm]
    double tip_radius = 0;     ///< tip circle of the circular spline [mm]
    double land = 0;           ///< tip land of the circular spline, in modules
    double flank_contact = 0;  ///< teeth of a lobe that touch with a flank at the same time
    double lost = 0;           ///< angle that a flank loses by undercut over the angle used
    bool wall_stress = false;  ///< bending stresses the wall more than the safety allows
    std::string refusal;       ///< why it is not taken; empty: it works
};

/// A wall under the teeth that was tried under torque.
struct WallTrial
{
    double wall = 0;            ///< [mm]
    double assembled = 0;       ///< largest von Mises stress in the cup on its wave generator, without torque [MPa]
    double loaded = 0;          ///< the same at the rated torque [MPa]
    double error = 0;           ///< estimated discretisation error of that; 0: not estimated [MPa]
    double side_clearance = 0;  ///< with which the teeth of the coned cup are clear [mm]
    double tip_radius = 0;      ///< tip circle of the circular spline with which they are [mm]
    bool interferes = false;    ///< no side clearance and tip circle of the search make both
    std::string refusal;        ///< why it is not taken; empty: it works
};

/// A key in which the design differs from the built-in type-50.
struct DesignDifference
{
    std::string key;      ///< path in the scene
    std::string here;     ///< value as it stands in the scene; empty: absent
    std::string type_50;  ///< the same there; empty: absent
    std::string why;      ///< the rule or the choice behind it
};

/// A designed drive.
struct Design
{
    DesignWishes wishes;           ///< as asked
    Scene scene;                   ///< what the rows with a key make
    std::vector<DesignRow> rows;   ///< in the order of the scene; rows without a key beside those that they belong to
    std::vector<MeshTrial> mesh;   ///< radial deformations tried, in growing order
    std::vector<WallTrial> walls;  ///< walls tried, in that order; empty without a torque
    std::vector<std::string> remarks;           ///< rules that are broken, and wishes that are met by the nearest value
    std::vector<DesignDifference> differences;  ///< from another drive, where that was asked for
    std::string other = "the built-in type-50";  ///< the drive that they are from

    /// The row of @p key. @throws std::logic_error where there is none
    [[nodiscard]] DesignRow const& row(std::string_view key) const;
};

/// Every wish that cannot be met by itself or beside the others, each with the nearest that works.
[[nodiscard]] Faults check_design(DesignWishes const& wishes);

/// Designs a drive.
///
/// Dimensions follow the rules of the thesis (Tables 2-1, 4-1 to 4-3, (4-1) to (4-5)), each inside its range where the
/// wishes allow it. Radial deformation and tip circle are searched with solve(): among those with a land on both
/// members as wide as asked, flanks that lose little by undercut and tips that part, that nearest to m (z_c - z_f)/2
/// is taken which has 95 % of the most teeth in flank contact. With a torque the pair is that of the bent cup, which
/// the scene then has with its slices, and the wall is searched with study_load(). The result has the same bits for any
/// number of threads.
/// @param wishes  what is asked for
/// @param talk    is told what is tried; null: nobody
/// @throws InputError with every wish that cannot be met (exit status 2); NumericalError where a computation fails
[[nodiscard]] Design design_drive(DesignWishes const& wishes, std::function<void(std::string const&)> const& talk = {});

/// Whether @p design has tooth family, teeth and module of @p other.
[[nodiscard]] bool is_like(Design const& design, Scene const& other);

/// The keys in which @p design and @p other differ, in the order of the design's rows; @p other's own keys last,
/// without those that have their standard value there.
[[nodiscard]] std::vector<DesignDifference> differences(Design const& design, Scene const& other);

/// What a wish was taken from, where a scene makes the wishes.
struct DerivedWish
{
    std::string option;  ///< of `hdconj design`, "--ratio"
    std::string value;   ///< as it is written there; empty: the wish is left out
    std::string from;    ///< the keys of the scene, or why they say nothing
};

/// Where a drive stands against a row of a design.
enum class RuleStanding
{
    as_proposed,  ///< the same value
    limited,      ///< the same value, outside the range of the rule
    within,       ///< another value inside the range
    outside,      ///< another value outside the range
    differs,      ///< another value, and the rule has no range
    unstated,     ///< the scene has no such line
    no_key        ///< no scene holds it
};
/// Words of RuleStanding.
template <>
inline constexpr std::array<std::string_view, 7> words_of<RuleStanding>{
    "as proposed",   "as proposed, outside the range", "within the range", "outside the range", "differs", "not stated",
    "not in a scene"};

/// A drive beside a row of a design.
struct ComparedRow
{
    std::string here;                              ///< the drive's value as a scene writes it; empty: none
    RuleStanding standing = RuleStanding::no_key;  ///< where it stands against the rule
    std::optional<DesignRange> range;              ///< of the rule, with the drive's own other dimensions
};

/// A drive against the design that its own wishes make.
struct SceneDesign
{
    Design design;                     ///< with the differences of the drive from it
    std::vector<DerivedWish> derived;  ///< in the order of the options
    std::vector<ComparedRow> here;     ///< one for each row of the design
};

/// The wishes that a scene stands for: i = z_f/(z_c - z_f), module, length of the cup over m z_f, torque of [load],
/// family, side clearance. What a scene does not hold has its standard value.
/// @param scene    of a drive
/// @param derived  is given where each comes from; null: nobody asks
/// @throws InputError for another difference of teeth or number of waves than two, for a tooth by points, and where the
/// circular spline's tooth is the one that is given: the rules know none of them
[[nodiscard]] DesignWishes wishes_of(Scene const& scene, std::vector<DerivedWish>* derived = nullptr);

/// Designs a drive by wishes_of() and lays the solved one beside it.
/// @throws as wishes_of() and design_drive()
[[nodiscard]] SceneDesign design_beside(Solution const& drive);

/// A ready drive, by its pitch diameter and rated torque.
struct ReadyDrive
{
    std::string_view name;  ///< "size-14"
    double diameter;        ///< wish [mm]
    double torque;          ///< wish [N mm]
};

/// Drives that `init --like` writes: the sizes that catalogues have, with dimensions of our own by these rules.
[[nodiscard]] std::vector<ReadyDrive> const& ready_drives();

/// The wishes of the ready drive @p name: ratio 100, a cup half as long as the pitch diameter, its torque.
/// @throws std::logic_error where no ready drive has that name
[[nodiscard]] DesignWishes ready_wishes(std::string_view name);

}  // namespace hdconj
