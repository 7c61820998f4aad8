// SPDX-License-Identifier: GPL-3.0-or-later
#include "limits.hpp"

#include <array>

namespace hdconj {
namespace {

constexpr double none = std::numeric_limits<double>::infinity();

constexpr DesignRange at_least(double low)
{
    return {low, none};
}
constexpr DesignRange at_most(double high)
{
    return {-none, high};
}
constexpr DesignRange any{};

/// Bending alternates once a wave: safeties against fatigue that are usual and accepted.
constexpr double usual_safety = 2, accepted_safety = 1.5;

constexpr std::array limits{
    DesignLimit{NoteCode::deformation,
                "2 w0/(m (z_c - z_f))",
                "1",
                {0.8, 1.2},
                {0.5, 1.5},
                "1 closes both pitch circles at the major axis; EP 0266972 has 0.8; slices of a short cup run from "
                "0.5 to 1.5 (type-50, coned)"},
    DesignLimit{NoteCode::tooth_difference, "(z_c - z_f)/n", "1", at_most(1), any,
                "the drives of all catalogues have one tooth a wave"},
    DesignLimit{NoteCode::flank_contact, "z_f u/(360 deg), u: angle over which a flank touches", "1", at_least(2),
                at_least(1), "contact ratio (ISO 21771): below 1 the flanks lose each other between two teeth"},
    DesignLimit{NoteCode::land, "land of the circular spline / m", "1", at_least(0.4), at_least(0.2),
                "tip thickness of cylindrical gears (Niemann, Winter): 0.4 m hardened, 0.2 m tempered"},
    DesignLimit{NoteCode::tip_land, "land of the flexspline / m", "1", at_least(0.4), at_least(0.2),
                "as for the land of the circular spline"},
    DesignLimit{NoteCode::undercut, "angle that a flank loses by undercut / angle over which it touches", "1",
                at_most(0.1), any, "below 0.1 little is lost; whether enough is left is judged by flank-contact"},
    DesignLimit{NoteCode::sharp_corner, "height of what the wire leaves, with its error / wedm.residual_limit", "1",
                at_most(1), any, "what the verb wedm accepts"},
    DesignLimit{NoteCode::narrow_space, "narrowest width of the space / (wire diameter + 2 gaps)", "1", at_least(1),
                any, "a narrower space cannot be entered"},
    DesignLimit{NoteCode::wall_stress, "E c w0 (n^2 - 1)/r_m^2, c: from the neutral layer to the surface", "MPa",
                at_most(usual_fatigue_strength / usual_safety), at_most(usual_fatigue_strength / accepted_safety),
                "thin ring (Timoshenko); 30CrMnSiA endures 670 MPa, over a safety of 2 and 1.5"},
    DesignLimit{NoteCode::late_mesh, "n u/180 deg, u: where a tip leaves the tip circle", "1", at_most(0.9),
                at_most(0.99), "1: the teeth never part, so that they cannot pass each other at the minor axis"},
    DesignLimit{NoteCode::backlash, "turn between first contacts of both flanks", "arcmin", at_least(0), at_least(0),
                "below 0 teeth press on both flanks without torque"},
    DesignLimit{NoteCode::teeth_end, "b/2 - z, b: width of the circular spline, z: where the teeth end on the bent cup",
                "mm", at_most(0), at_most(0), "above 0 a part of the circular spline has no tooth beside it"}};

}  // namespace

std::span<DesignLimit const> design_limits()
{
    return limits;
}

std::vector<DesignLimit> design_limits(Scene const& scene)
{
    std::vector<DesignLimit> own(limits.begin(), limits.end());
    double const strength = scene.flexspline.cup ? scene.flexspline.cup->fatigue_strength : usual_fatigue_strength;
    if (strength != usual_fatigue_strength) {
        DesignLimit& stress = own[static_cast<std::size_t>(NoteCode::wall_stress)];
        stress.usual = at_most(strength / usual_safety);
        stress.accepted = at_most(strength / accepted_safety);
        stress.source = "thin ring (Timoshenko); flexspline.cup.fatigue_strength over a safety of 2 and 1.5";
    }
    return own;
}

}  // namespace hdconj

namespace hdconj::judgement {

DesignLimit const& limit_of(NoteCode code)
{
    return design_limits()[static_cast<std::size_t>(code)];
}

std::optional<Note> note_on(NoteCode code, double figure)
{
    return note_on(limit_of(code), figure);
}

std::optional<Note> note_on(DesignLimit const& limit, double figure)
{
    if (limit.usual.contains(figure))
        return std::nullopt;
    Note note;
    note.code = limit.code;
    note.severity = limit.accepted.contains(figure) ? Severity::information : Severity::warning;
    DesignRange const& left = note.severity == Severity::warning ? limit.accepted : limit.usual;
    note.figure = figure;
    note.limit = figure < left.low ? left.low : left.high;
    note.unit = limit.unit;
    return note;
}

}  // namespace hdconj::judgement
