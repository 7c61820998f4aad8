// SPDX-License-Identifier: GPL-3.0-or-later
#include "part_of_case.hpp"

#include "base/text.hpp"
#include "drive/elastic_cup.hpp"
#include "hdconj/error.hpp"
#include "judgement/judgement.hpp"
#include "surface/build_slices.hpp"
#include "wedm/sharp_corner.hpp"

namespace hdconj::pipeline {
namespace {

using surface::SurfaceSpec;
using surface::ToothSurfaceBuilder;

void write_with(Solution& out, contact::ContactStudyData& data, SurfaceSpec const& spec, double tip,
                double side_clearance)
{
    std::vector<double> const& z = data.maker->z();
    surface::SurfaceSampling const sampling{data.scene.solver.tolerance, 0, true};
    if (side_clearance == 0) {
        if (z.size() > 1)
            surface::write_outlines(out, data.maker->outline(spec, tip, sampling), data.tooth, z, spec.surface);
        return;
    }
    conjugate::SolvedPlane const solved =
        contact::plane_with_clearance(data.scene, side_clearance, tip, data.middle.cup);
    Solution const& base = solved.solution;
    out.judgement = base.judgement;
    if (z.size() == 1) {
        out.circular_spline = base.circular_spline;
        out.error.chord = base.error.chord;
        out.error.point = base.error.point;
        return;
    }
    ToothSurfaceBuilder builder(base, *data.maker);
    surface::write_outlines(out, builder.outline(spec, tip, sampling), data.tooth, z, spec.surface);
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

double write_part(Solution& out, contact::ContactStudyData& data, SurfaceSpec const& spec, double tip,
                  double side_clearance)
{
    try {
        write_with(out, data, spec, tip, side_clearance);
        judge_part(out, data, spec, tip);
        return side_clearance;
    } catch (NumericalError const& error) {
        if (side_clearance == 0)
            throw;
        write_with(out, data, spec, tip, 0);
        judge_part(out, data, spec, tip);
        out.notes.push_back("the outline is written without side clearance, because with " +
                            short_number(side_clearance) + " mm it cannot be made: " + error.what());
        return 0;
    }
}

}  // namespace hdconj::pipeline
