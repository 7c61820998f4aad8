// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The scene: everything a user says about a drive, as plain data. Members are in mm and rad; the parameters of a
/// family (scene::FamilyChoice::given) keep the units of the scene file, so that "pressure_angle_deg" holds degrees.
/// Defaults are those of a scene file.
// Long: the tables of a scene belong together.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hdconj/scene/parameters.hpp"
#include "hdconj/scene_words.hpp"
#include "hdconj/units.hpp"

namespace hdconj {

/// The pair of gears.
struct Drive
{
    std::string name;               ///< of the drive, for titles and file names
    double module = 0;              ///< m [mm]
    int flexspline_teeth = 0;       ///< z_f
    int circular_spline_teeth = 0;  ///< z_c
};

/// Alternating bending that the flexspline's steel endures where a scene does not say so [MPa]: 30CrMnSiA. Source:
/// thesis, table of materials.
inline constexpr double usual_fatigue_strength = 670;

/// Effect: the cup below the toothed ring, for what needs an elastic body. Heights along the axis, lengths in mm.
struct Cup
{
    double length = 0;                   ///< from the outer face of the bottom to the open end
    double barrel_wall = 0;              ///< of the barrel and of the land in front of the teeth
    double bottom = 0;                   ///< thickness of the bottom
    double corner_radius = 0;            ///< outer fillet between bottom and barrel
    double flange_radius = 0;            ///< inside it the bottom is clamped
    double tooth_width = 0;              ///< of the toothed ring
    double front_land = 0;               ///< from the teeth to the open end
    std::optional<double> rear_ramp;     ///< over which the wall grows to that of the ring; default as long as it grows
    std::optional<double> front_ramp;    ///< the same in front
    std::optional<double> rear_fillet;   ///< radius of an arc in place of the ramp
    std::optional<double> front_fillet;  ///< the same in front
    std::optional<double> tooth_layer;   ///< effect: height of the teeth as a layer that stiffens the ring
    double tooth_share = 0.5;            ///< of that layer that is steel
    double youngs_modulus = 206e3;       ///< [MPa]
    double poissons_ratio = 0.3;         ///< Poisson's ratio
    double fatigue_strength = usual_fatigue_strength;  ///< sigma_-1, alternating bending, for the judgement [MPa]
    int line = 0;                                      ///< of the table in the scene file, 1-based; 0: by --set
};

/// The flexspline: the elastic, externally toothed cup.
struct Flexspline
{
    double wall = 0;                     ///< delta [mm], under the teeth
    std::optional<double> inner_radius;  ///< [mm]; default m z_f/2 - h_f - delta
    double neutral_offset = 0;           ///< [mm], neutral layer this far inside the middle of the wall
    scene::FamilyChoice profile;         ///< no family where the circular spline's tooth is given
    std::optional<double> addendum;      ///< h_a [mm] of the tooth that is solved for; absent where it is given
    std::optional<double> dedendum;      ///< h_f [mm] of it
    std::optional<Cup> cup;              ///< the cup below the teeth; absent: not given
};

/// The wave generator: the shape that deforms the flexspline.
struct WaveGenerator
{
    scene::FamilyChoice shape;  ///< family and its parameters
    int waves = 2;              ///< n
};

/// The circular spline: the internally toothed ring.
struct CircularSpline
{
    std::optional<double> width;                 ///< [mm], axial; recorded, used by axial effects
    double backlash_offset = 0;                  ///< [mm], along the normal, >= 0
    bool automatic_backlash = false;             ///< "auto": the least offset that clears every slice over a full turn
    double root_clearance = 0;                   ///< [mm], along the centre line of the space, >= 0
    double youngs_modulus = 210e3;               ///< [MPa]
    double poissons_ratio = 0.3;                 ///< Poisson's ratio, for loads
    std::optional<double> inner_radius;          ///< tip circle [mm]; default r_m + delta/2 + h_f + w0 - h_a
    std::optional<scene::FamilyChoice> profile;  ///< given: the reverse problem, or the neutral curve is wanted
};

/// How the drive is computed.
struct Solver
{
    Kinematics kinematics = Kinematics::exact;  ///< model of the relative motion
    double tolerance = 1e-6;                    ///< [mm], largest distance of an output outline from the true one
    int threads = 0;                            ///< 0: all cores, at most OMP_NUM_THREADS
};

/// Effect: the flexspline cones along the axis.
struct Coning
{
    ConingModel model = ConingModel::linear;      ///< of the displacement along the axis
    std::optional<double> bottom_to_middle;       ///< [mm]
    double apex_height = 0;                       ///< of the apex above the cup's bottom [mm]
    AxialShift axial_shift = AxialShift::mapped;  ///< whether gaps know of the axial displacement
    int line = 0;                                 ///< of the table in the scene file, 1-based; 0: by --set
};

/// Effect: the wave generator's bearing, for what needs to know how it gives way. Lengths in mm.
struct BearingChoice
{
    bool elastic = false;                    ///< whether its outer ring bends; otherwise its surface is that of the cam
    double width = 0;                        ///< over which the cup may touch it
    std::optional<double> ring_thickness;    ///< of the outer ring
    double fit = 0;                          ///< interference of the outer ring with the cup, of radii
    double cam_oversize = 0;                 ///< preload of the balls, of radii
    std::optional<double> radial_stiffness;  ///< of the line of balls [N/mm per mm of arc]; default rigid
    bool axially_held = true;                ///< whether the groove keeps the line of balls from moving along the axis
    std::optional<int> balls;                ///< how many, each a force of its own under load; absent: a line
    double ball_phase = 0;                   ///< angle of one of them from the major axis, clockwise [rad]
    std::optional<double> ball_diameter;     ///< effect: each ball yields by Hertz; absent: by radial_stiffness
    double inner_conformity = 0.52;          ///< radius of the groove of the inner ring over the ball diameter
    double outer_conformity = 0.52;          ///< the same of the outer ring
    double clearance = 0;                    ///< diametral, under load only
    double youngs_modulus = 206e3;           ///< of both rings [MPa]
    double poissons_ratio = 0.3;             ///< of both rings
    double ball_youngs_modulus = 206e3;      ///< of the balls [MPa]
    double ball_poissons_ratio = 0.3;        ///< of the balls
    int angles = 48;                         ///< points of contact in a lobe
    int circles = 13;                        ///< and over the width
    int line = 0;                            ///< of the table in the scene file, 1-based; 0: by --set
};

/// Effect: members in series with the teeth that yield in torsion, as the circular spline feels them. Absent: rigid.
struct Compliance
{
    std::optional<double> flange;        ///< torsional stiffness of the cup's flange and its screws [N mm/rad]
    std::optional<double> hub;           ///< of the hub behind it [N mm/rad]
    std::optional<double> shaft;         ///< of the shaft that carries the torque on [N mm/rad]
    std::optional<double> outer_radius;  ///< where the body of the circular spline is held [mm]
    int line = 0;                        ///< of the table in the scene file, 1-based; 0: by --set
};

/// Effect: tilted circular-spline teeth.
struct Tilt
{
    double angle = 0;                  ///< [rad]
    TiltKind kind = TiltKind::radial;  ///< how the outline is moved
    int line = 0;                      ///< of the table in the scene file, 1-based; 0: by --set
};

/// Effect: more than one slice across the face width.
struct Slices
{
    int count = 1;                                ///< number of slices, equally spaced over the face width
    ToothSurface surface = ToothSurface::tilted;  ///< how the tooth surface is made
    int line = 0;                                 ///< of the table in the scene file, 1-based; 0: by --set
};

/// Effect: the flexspline's flanks stand back towards the tips. Only the verb `load` reads it.
struct TipRelief
{
    double amount = 0;       ///< at the tip, along the flank's normal [mm]
    double from_height = 0;  ///< height above the pitch line at which it begins [mm]
    int line = 0;            ///< of the table in the scene file, 1-based; 0: by --set
};

/// Effect: the flanks stand back towards both ends of the face width. Only the verb `load` reads it.
struct EndRelief
{
    double amount = 0;  ///< at the ends, along the flank's normal [mm]
    double length = 0;  ///< along the face width over which it grows [mm]
    int line = 0;       ///< of the table in the scene file, 1-based; 0: by --set
};

/// Effect: the steel of the flanks flows under a contact pressure. Only the verb `load` reads it.
struct Flow
{
    double pressure = 0;  ///< mean over the strip in contact, about three times the yield strength [MPa]
    int line = 0;         ///< of the table in the scene file, 1-based; 0: by --set
};

/// Errors of one ring of teeth: how it is made and how it sits on its axis.
struct RingErrors
{
    double pitch_deviation = 0;     ///< standard deviation of the places of teeth along the pitch circle [mm]
    std::vector<double> pitch;      ///< the place of each, clockwise [mm]; empty: random ones, by pitch_deviation
    double eccentricity = 0;        ///< of the ring against the axis [mm]
    double eccentricity_phase = 0;  ///< where the ring stands out, clockwise from its tooth or space 0 [rad]
    double wobble = 0;              ///< angle between the ring's axis and the drive's, in the middle of the width [rad]
    double wobble_phase = 0;        ///< the same as eccentricity_phase, at the cup's open end [rad]
    double profile_slope = 0;       ///< of the flanks: excess of metal at the tip over the root [mm]
    scene::NumberRows profile_form;  ///< rows of height above the pitch line and excess of metal [mm]
    int line = 0;                    ///< of the table in the scene file, 1-based; 0: by --set
};

/// Errors of the wave generator: how it is made and how it sits on its axis.
struct WaveGeneratorErrors
{
    double eccentricity = 0;          ///< of the wave generator against the axis [mm]
    double eccentricity_phase = 0;    ///< where it stands out, clockwise from its major axis [rad]
    scene::NumberRows cam_deviation;  ///< rows of angle from the major axis [rad] and radial excess [mm]
    int line = 0;                     ///< of the table in the scene file, 1-based; 0: by --set
};

/// Effect: errors of making and assembly. Only the verb `load` reads it.
struct Errors
{
    std::optional<RingErrors> flexspline;               ///< effect [errors.flexspline]
    std::optional<RingErrors> circular_spline;          ///< effect [errors.circular_spline]
    std::optional<WaveGeneratorErrors> wave_generator;  ///< effect [errors.wave_generator]
    int seed = 0;                                       ///< of random places of teeth
    double profile_slope = 0;        ///< of the flexspline's flanks: excess at the tip over the root [mm]
    scene::NumberRows profile_form;  ///< rows of height above the pitch line and excess [mm]
    int line = 0;                    ///< of the table in the scene file, 1-based; 0: by --set
};

/// What contact is asked for. Only the verb `contact` reads it.
struct ContactRequest
{
    double gap = 0.001;         ///< contact where the gap is no larger [mm]
    int flank_points = 200;     ///< along each flank
    double wave_generator = 0;  ///< angle of the wave generator from a tooth space [rad]
    int line = 0;               ///< of the table in the scene file, 1-based; 0: by --set
};

/// What a load is asked for. Only the verb `load` reads it.
struct LoadRequest
{
    std::optional<double> torque;         ///< rated, on the circular spline [N mm]
    int points = 0;                       ///< torques from 0 to the rated one; 0: as many as needed
    int harmonics = 100;                  ///< highest one around the circumference
    std::optional<double> first_torque;   ///< T1 of the stiffness K1 [N mm]; default 0.175 of the rated one
    std::optional<double> second_torque;  ///< T2 of the stiffness K2 [N mm]; default 0.625 of the rated one
    std::optional<double> edge_radius;    ///< of the lands' edges under load [mm]; default 1/25 of the module
    int line = 0;                         ///< of the table in the scene file, 1-based; 0: by --set
};

/// What a running drive is asked for. Only the verb `run` reads it.
struct RunRequest
{
    RunningMember output = RunningMember::flexspline;  ///< the member that turns; the other one is held
    int positions = 0;                                 ///< of the wave generator; 0: as many as needed
    std::vector<double> torques;                       ///< on the output, of the efficiency [N mm]
    std::vector<double> speeds;                        ///< of the wave generator [rad/s]
    std::vector<double> temperatures;                  ///< of the lubricant [degrees Celsius]
    int line = 0;                                      ///< of the table in the scene file, 1-based; 0: by --set
};

/// Effect: what the drive loses while it runs. Only the verb `run` reads it.
struct Friction
{
    double flanks = 0;                     ///< coefficient of sliding flanks
    std::optional<double> flanks_at_rest;  ///< the same as the speed goes to 0; absent: Coulomb's law
    double stribeck_speed = 0;             ///< of sliding at which their difference has fallen to 1/e [mm/s]
    double bearing_load = 0;               ///< Palmgren's f1: M1 = f1 P d_m
    double bearing_speed = 0;              ///< Palmgren's f0: M0 = 1e-7 f0 (nu n)^(2/3) d_m^3
    std::optional<double> viscosity_40;    ///< of the lubricant at 40 degrees Celsius [mm^2/s]
    std::optional<double> viscosity_100;   ///< of the lubricant at 100 degrees Celsius [mm^2/s]
    double seal = 0;                       ///< torque of the seals on the wave generator's shaft [N mm]
    double churning = 0;                   ///< torque for each unit of the shaft's speed [N mm s/rad]
    int line = 0;                          ///< of the table in the scene file, 1-based; 0: by --set
};

/// How the part is cut by wire. Only the verb `wedm` reads it. Lengths in mm.
struct WireRequest
{
    WirePart part = WirePart::circular_spline;  ///< that is cut
    std::optional<double> thickness;            ///< of the workpiece; default the width of the toothing
    double wire_diameter = 0;                   ///< stated by the user, never assumed
    double spark_gap = 0;                       ///< between wire and part; stated by the user, never assumed
    double lower_guide = 20;                    ///< lower guide point below the lower face
    double upper_guide = 30;                    ///< upper guide point above the upper face
    std::vector<double> stock;                  ///< left by each pass, in order; the last one leaves none
    bool alternating = false;                   ///< every second pass runs against the first
    int start = 0;                              ///< tooth space beside whose tip land the path begins
    double lead_in = 3;                         ///< from the start hole's centre to the nominal contour
    double start_hole_radius = 0.5;             ///< distance of its centre from the axis
    double overlap = 0;                         ///< beyond the point where the contour closes
    double stop_before = 1;                     ///< first pass: stop this far before it closes; 0: no stop
    WireStop stop = WireStop::always;           ///< the word of that stop
    double tolerance = 0.0005;            ///< largest distance of the surface cut from the nominal one, residuals apart
    double residual_limit = 0.01;         ///< residual material that is accepted
    std::optional<double> surface_limit;  ///< error between the faces that is accepted; default the tolerance
    double largest_tilt = 30 * deg;       ///< of the wire that the machine can make [rad]
    std::optional<double> largest_travel;     ///< of each axis of each guide from the start hole, either way
    std::optional<double> largest_uv_travel;  ///< of each axis of the upper guide against the lower one, either way
    int decimals = 4;                         ///< of rounded outputs
    std::string dialects;                     ///< names, separated by blanks; empty: all that fit
    int line = 0;                             ///< of the table in the scene file, 1-based; 0: by --set
};

/// Where a key or table of the scene was given, for messages.
struct GivenKey
{
    int line = 0;         ///< 1-based; 0: by --set
    std::string written;  ///< the value as the user wrote it; empty for a table
};

/// Name of the wave generator family of a scene that looks for its neutral curve.
inline constexpr std::string_view wanted_neutral_curve = "wanted";

/// A drive and what is to be computed of it. An effect that is absent has no object.
struct Scene
{
    Drive drive;                            ///< table [drive]
    Flexspline flexspline;                  ///< table [flexspline]
    WaveGenerator wave_generator;           ///< table [wave_generator]
    CircularSpline circular_spline;         ///< table [circular_spline]
    Solver solver;                          ///< table [solver]
    std::optional<Coning> coning;           ///< effect [coning]
    std::optional<BearingChoice> bearing;   ///< effect [wave_generator.bearing]
    std::optional<Compliance> compliance;   ///< effect [compliance]
    std::optional<Tilt> tilt;               ///< effect [tilt]
    std::optional<Slices> slices;           ///< effect [slices]
    std::optional<TipRelief> tip_relief;    ///< effect [tip_relief]
    std::optional<EndRelief> end_relief;    ///< effect [end_relief]
    std::optional<Flow> flow;               ///< effect [flow]
    std::optional<Errors> errors;           ///< effect [errors]
    std::optional<ContactRequest> contact;  ///< table [contact]
    std::optional<LoadRequest> load;        ///< table [load]
    std::optional<RunRequest> running;      ///< table [running]
    std::optional<Friction> friction;       ///< effect [friction]
    std::optional<WireRequest> wedm;        ///< table [wedm]

    std::string text;                                    ///< the scene as given, after --set
    std::map<std::string, GivenKey, std::less<>> given;  ///< each key and table that is there, by path
    std::filesystem::path folder;                        ///< where relative file names start
    scene::NamedTexts files;                             ///< what the files held that it names, when it was read

    /// Whether the circular spline's tooth is given and the flexspline's solved for.
    [[nodiscard]] bool is_reverse() const { return circular_spline.profile.has_value() && !wants_neutral_curve(); }
    /// Whether both teeth are given and the neutral curve is looked for, wave_generator.family = "wanted".
    [[nodiscard]] bool wants_neutral_curve() const { return wave_generator.shape.family == wanted_neutral_curve; }
    /// Whether the cup's displacements come from the elastic model.
    [[nodiscard]] bool is_elastic() const { return coning && coning->model == ConingModel::elastic; }
    /// Whether gaps are computed where the cone has moved the wall to along the axis.
    [[nodiscard]] bool maps_axial_shift() const { return coning && coning->axial_shift == AxialShift::mapped; }
    /// The tooth that is given.
    [[nodiscard]] scene::FamilyChoice const& given_profile() const
    {
        return is_reverse() ? *circular_spline.profile : flexspline.profile;
    }
    /// h_f of the flexspline tooth where the scene says it in so many words.
    [[nodiscard]] std::optional<double> flexspline_dedendum() const
    {
        return is_reverse() ? flexspline.dedendum : flexspline.profile.number("dedendum");
    }
};

}  // namespace hdconj
