// SPDX-License-Identifier: GPL-3.0-or-later
#include "part_of_case.hpp"

#include "base/text.hpp"
#include "contact/clearance/side_clearance_search.hpp"
#include "drive/elastic_cup.hpp"
#include "hdconj/error.hpp"
#include "judgement/judgement.hpp"
#include "surface/build_slices.hpp"
#include "wedm/sharp_corner.hpp"

namespace hdconj::pipeline {
namespace {

using surface::SurfaceSpec;
using surface::ToothSurfaceBuilder;

/// What the plane z = 0 says of the circular spline that the scene asks for; see solution_with_part().
Solution drive_of_scene(contact::ContactStudyData& data, PartOfCase const& part)
{
    CircularSpline const& asked = data.scene.circular_spline;
    double const nominal_tip = data.middle.geometry.circular_spline_inner_radius;
    auto const with = [&](double side_clearance, double tip) {
        Solution out = data.plane_with(side_clearance, tip);
        out.timing = data.middle.timing;
        out.notes = data.middle.notes;
        out.error.cup = data.middle.error.cup;
        return out;
    };
    if (asked.automatic_backlash) {
        Solution out = with(part.side_clearance, part.tip);
        contact::add_side_clearance_error(out.error,
                                          contact::error_of_least(data.context->tolerance, part.side_clearance));
        return out;
    }
    double const given = contact::given_clearance(data.scene);
    try {
        return with(given, nominal_tip);
    } catch (NumericalError const& error) {
        if (!error.is_infeasible() || part.tip == nominal_tip)
            throw;
        Solution out = with(given, part.tip);
        out.notes.push_back("dimensions are those of a tip circle of " + short_number(part.tip) + " mm: with one of " +
                            short_number(nominal_tip) +
                            " mm the circular spline cannot be made with a side clearance of " + short_number(given) +
                            " mm");
        return out;
    }
}

void write_outline(Solution& out, contact::ContactStudyData& data, PartOfCase const& part)
{
    std::vector<double> const& z = data.maker->z();
    auto const write = [&](ToothSurfaceBuilder& builder) {
        surface::write_outlines(out, builder.outline(part.spec, part.tip, {data.scene.solver.tolerance, 0, true}),
                                data.tooth, z, part.spec.surface);
    };
    if (part.side_clearance == 0) {
        if (z.size() > 1)
            write(*data.maker);
        return;
    }
    Solution const& base = data.plane_with(part.side_clearance, part.tip);
    out.judgement = base.judgement;
    if (z.size() == 1) {
        out.circular_spline = base.circular_spline;
        out.error.chord = base.error.chord;
        out.error.point = base.error.point;
        return;
    }
    ToothSurfaceBuilder builder(base, *data.maker);
    write(builder);
}

/// Judges where the tips leave the tip circle once more: the pair at z = 0 does not know the tilt of the case.
void judge_tilted_tips(Solution& out, Scene const& asked, SurfaceSpec const& spec, double tip)
{
    if (spec.tilt == 0)
        return;
    Scene scene = contact::middle_scene(asked);
    scene.circular_spline.inner_radius = tip;
    scene.tilt = Tilt{spec.tilt, spec.kind, 0};
    scene.slices = asked.slices;
    judgement::judge_late_mesh_again(out.judgement, scene);
}

/// Judges whether the circular spline reaches beyond the teeth of a cup that is known.
void judge_end_of_teeth(Solution& out, contact::ContactStudyData const& data)
{
    elastic::BentCup const* const cup = data.context->cup;
    if (!cup || data.maker->z().size() < 2)
        return;
    double const front = drive::front_of_teeth(*cup, data.context->geometry.r_m);
    if (auto const note = judgement::teeth_end(data.scene, front))
        out.judgement.push_back(*note);
}

/// What is judged of the part of a case alone.
void judge_part(Solution& out, contact::ContactStudyData const& data, SurfaceSpec const& spec, double tip)
{
    judge_tilted_tips(out, data.scene, spec, tip);
    judge_end_of_teeth(out, data);
    wedm::judge_sharp_corner(out.judgement, data.scene, out.circular_spline);
}

}  // namespace

Solution solution_with_part(contact::ContactStudyData& data, PartOfCase const& part)
{
    Solution out = drive_of_scene(data, part);
    write_outline(out, data, part);
    judge_part(out, data, part.spec, part.tip);
    return out;
}

}  // namespace hdconj::pipeline
