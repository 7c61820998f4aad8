// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Inspection: measured points of a part against its nominal outline. All lengths in mm, all angles in rad.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hdconj/base/vec2.hpp"
#include "hdconj/error.hpp"
#include "hdconj/plan.hpp"
#include "hdconj/scene.hpp"
#include "hdconj/solution.hpp"

namespace hdconj {

/// The part that was measured.
enum class InspectedPart
{
    flexspline,      ///< before assembly: its ring is round
    circular_spline  ///< a tooth of it is a tooth space here
};
/// Words of InspectedPart.
template <>
inline constexpr std::array<std::string_view, 2> words_of<InspectedPart>{"flexspline", "circular-spline"};

/// How the points are laid on the nominal part.
enum class Registration
{
    datum,          ///< as they are: the file's axes are those of the part
    turn,           ///< turned about the axis: least sum of squared deviations
    least_squares,  ///< turned and shifted: least sum of squared deviations
    minimum_zone    ///< turned and shifted: least largest deviation
};
/// Words of Registration.
template <>
inline constexpr std::array<std::string_view, 4> words_of<Registration>{"datum", "turn", "least-squares",
                                                                        "minimum-zone"};

/// A measured point: the centre of the probe's ball, or a point of the surface.
struct PartPoint
{
    Vec2 where = Vec2::Zero();  ///< the axis of the part at (0, 0), the middle of tooth 1 (space 1) on +y
    double z = 0;               ///< plane; 0 where the file has no such column
    int tooth = 0;              ///< number in the file; 0: none
    std::optional<bool> right;  ///< flank that the file names; absent: the nearer one
    int line = 0;               ///< of the file
    std::size_t layer = 0;      ///< of a drawing: index into PointFile::layers
};

/// A file of measured points.
struct PointFile
{
    std::string file;                   ///< as given
    std::vector<PartPoint> points;      ///< in the order of the file
    bool has_z = false;                 ///< whether the file says the plane of each point
    std::vector<std::string> layers{};  ///< of a drawing: those that have points
};

/// A larger file is refused unread [bytes].
inline constexpr std::uintmax_t largest_point_file = std::uintmax_t{64} << 20;
/// A file of more points is refused.
inline constexpr std::size_t most_part_points = 500'000;

/// What examine_points() finds.
struct PointReading
{
    PointFile measured;  ///< of use only without faults
    Faults faults;       ///< every fault of the file
};

/// Reads measured points: a CSV file whose first line names the columns x, y and, where they are known, z, tooth and
/// flank (left, right). Lengths are in mm unless a heading says otherwise: "x [inch]". Or a DXF file (ending .dxf): its
/// points and the vertices of its polylines.
[[nodiscard]] PointReading examine_points(std::filesystem::path const& file);

/// What is asked of an inspection.
struct InspectOptions
{
    InspectedPart part = InspectedPart::flexspline;           ///< that was measured
    std::optional<double> plane;                              ///< only points there; absent: all planes of the file
    double probe = 0;                                         ///< radius of the ball whose centres are given; negative:
                                                              ///< centres lie inside the material; 0: surface points
    Registration registration = Registration::least_squares;  ///< of the points
};

/// A figure and the half width of its interval, which holds the figure of the part without noise in 95 of 100
/// measurements. NaN: the points are too few to tell.
struct Uncertain
{
    double value = 0;  ///< the figure
    double error = 0;  ///< half width of the 95 % interval
};

/// The nominal outline in one plane.
struct NominalFigures
{
    double z = 0;                 ///< of the plane
    double flank_length = 0;      ///< arc length of the evaluated flank, from root to tip
    double reference_radius = 0;  ///< of the circle through the middles of the flanks
    double thickness = 0;         ///< of a tooth along that circle
    double error = 0;             ///< of the outline
};

/// One flank. Deviations are along the nominal normal, positive where there is too much material.
struct FlankFigures
{
    double z = 0;            ///< of the plane
    int tooth = 0;           ///< number of the tooth, of the space on the circular spline
    bool right = false;      ///< which flank, seen with the axis below
    std::size_t points = 0;  ///< evaluated
    Uncertain position;      ///< arc along the reference circle by which the flank is turned clockwise
    Uncertain total;         ///< largest less smallest deviation of the flank, turned to its own position
    Uncertain slope;         ///< rise of the parabola of least squares from root to tip
    Uncertain crowning;      ///< height of that parabola at the middle above its chord
    Uncertain form;          ///< largest less smallest deviation from that parabola
};

/// One tooth with both flanks; on the circular spline one space.
struct ToothFigures
{
    double z = 0;         ///< of the plane
    int tooth = 0;        ///< number of the tooth, of the space on the circular spline
    Uncertain thickness;  ///< of the tooth, or width of the space, along the reference circle
    Uncertain radial;     ///< outward shift of tooth or space
};

/// The left or the right flanks of a plane.
struct SideFigures
{
    double z = 0;             ///< of the plane
    bool right = false;       ///< which flanks
    std::size_t flanks = 0;   ///< evaluated
    Uncertain slope;          ///< mean over the flanks
    Uncertain crowning;       ///< mean over the flanks
    Uncertain form;           ///< largest of the flanks
    int form_tooth = 0;       ///< where
    Uncertain total;          ///< largest of the flanks
    int total_tooth = 0;      ///< where
    std::size_t pitches = 0;  ///< between neighbours that are both measured
    Uncertain single_pitch;   ///< f_pt: largest size of a pitch deviation; of no use without pitches
    int pitch_tooth = 0;      ///< the second of the two teeth
    Uncertain total_pitch;    ///< F_p: largest less smallest position
    int from_tooth = 0;       ///< with the smallest position
    int to_tooth = 0;         ///< with the largest
};

/// A plane as a whole.
struct PlaneFigures
{
    double z = 0;            ///< of the plane
    std::size_t teeth = 0;   ///< with both flanks
    Uncertain thickness;     ///< mean
    Uncertain runout;        ///< largest less smallest radial shift of the teeth
    int near_tooth = 0;      ///< with the smallest radial shift
    int far_tooth = 0;       ///< with the largest
    bool circle = false;     ///< whether the teeth suffice for an eccentricity
    Uncertain eccentricity;  ///< amplitude of the first harmonic of the radial shifts
    double direction = 0;    ///< in which the part is shifted, clockwise from +y
};

/// What became of a point.
enum class PointFate
{
    used,    ///< in every figure
    beside,  ///< its foot is on no flank: tip land, root, or beyond the ends
    stray    ///< jumps against its neighbours and the other flanks: left out
};
/// Words of PointFate.
template <>
inline constexpr std::array<std::string_view, 3> words_of<PointFate>{"used", "beside", "stray"};

/// The deviation of one point after registration.
struct PointDeviation
{
    int line = 0;                      ///< of the file
    double z = 0;                      ///< of the plane
    int tooth = 0;                     ///< number
    bool right = false;                ///< which flank
    double arc_length = 0;             ///< of its foot, from the root end of the flank
    double deviation = 0;              ///< along the nominal normal, positive outside the material
    PointFate fate = PointFate::used;  ///< what became of it
};

/// How the points lie on the nominal part.
struct PartPlacement
{
    Uncertain turn;              ///< of the measured part, clockwise
    Uncertain shift_x;           ///< of its axis
    Uncertain shift_y;           ///< of its axis
    double rms = 0;              ///< of the deviations
    double least = 0;            ///< smallest deviation
    double largest = 0;          ///< largest deviation
    double deviation_error = 0;  ///< of a single deviation: half width of its 95 % interval
};

/// Result of inspect_points().
struct Inspection
{
    Scene scene;                          ///< of the drive
    InspectOptions options;               ///< as asked
    std::string file;                     ///< of the points
    std::vector<NominalFigures> nominal;  ///< by plane
    PartPlacement placement;              ///< of the part
    double noise = 0;                     ///< standard deviation of a point, from second differences along the flanks
    double freedom = 0;                   ///< degrees of freedom of that estimate; 0: no estimate
    std::vector<PointDeviation> points;   ///< every point of the planes, in the order of the file
    std::vector<FlankFigures> flanks;     ///< by plane, tooth, left before right
    std::vector<ToothFigures> teeth;      ///< by plane and tooth
    std::vector<SideFigures> sides;       ///< by plane, left before right
    std::vector<PlaneFigures> planes;     ///< those with a tooth of two flanks
    std::vector<Vec2> mean_flank;         ///< of the teeth in the first plane: right flank from tip to root, y from the
                                          ///< pitch line towards the tip; empty where a side has no flank
    PairGeometry geometry;                ///< of the drive, where it was solved for the nominal outline
    std::size_t beside = 0;               ///< points on no flank
    std::size_t strays = 0;               ///< points left out
    std::size_t repeated = 0;             ///< points that stand in the file before, not among `points`
    std::size_t elsewhere = 0;            ///< points of planes that were not asked for, not among `points`
    std::vector<std::string> notes;       ///< what a reader should know
};

/// Lays @p measured on the nominal outline of a part and evaluates its flanks, their pitch, runout and thickness.
///
/// The deviation of a point is its signed distance to the nominal flank, less the probe's radius: positive outside the
/// material. A flank is turned about the axis until the parabola of least squares through its deviations against arc
/// length is 0 at the middle of the flank; docs/how-to/measure-a-ring.md defines each figure. Accuracy: roundoff for
/// points without noise; the nominal outline of a member that is solved for is a cubic spline through its points, whose
/// error NominalFigures::error says.
/// @param scene     of the drive; is solved where the part's tooth is not given
/// @param measured  points of one tooth, of several, or of a whole ring [mm]
/// @param options   part, planes, registration and probe
/// @param on_stage  of the solution
/// @throws InputError where the points do not belong to the part or do not fix the registration; NumericalError
[[nodiscard]] Inspection inspect_points(Scene const& scene, PointFile const& measured, InspectOptions const& options,
                                        StageObserver const& on_stage = {});

}  // namespace hdconj
