// SPDX-License-Identifier: GPL-3.0-or-later
#include "study_drive.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "given_contact.hpp"
#include "hdconj/conjugate/outline.hpp"
#include "hdconj/envelope/find_branches.hpp"
#include "hdconj/envelope/rest.hpp"
#include "hdconj/pipeline/solve.hpp"
#include "hdconj/profile/registry.hpp"

namespace hdconj::detail {
namespace {

Profile tooth_of(Scene const& scene)
{
    int const difference = scene.drive.circular_spline_teeth - scene.drive.flexspline_teeth;
    Faults faults;
    Profile tooth = build_profile(scene.flexspline.profile,
                                  {scene.drive.module, scene.drive.flexspline_teeth, scene.flexspline.wall, scene.flexspline.neutral_offset,
                                   scene.folder.string(), false, difference, scene.wave_generator.waves},
                                  faults);
    if (!faults.empty())
        throw InputError(faults);
    return tooth;
}

}  // namespace

std::optional<GivenShape> given_shape(Scene const& scene)
{
    std::string const& family = scene.wave_generator.shape.family;
    if (family == "cosine")
        return GivenShape::cosine;
    if (family == "ellipse")
        return GivenShape::ellipse;
    if (family == "ring-on-cosine-cam")
        return GivenShape::ring_on_cosine_cam;
    return std::nullopt;
}

GivenNumbers StudyDrive::numbers() const
{
    return {given_shape(scene).value(), geometry.w0,       scene.wave_generator.waves, geometry.r_m, scene.wave_generator.shape.number_or("ring_thickness", 0),
            scene.drive.flexspline_teeth, scene.drive.circular_spline_teeth};
}

bool StudyDrive::is_flank(BoundaryPiece const& piece) const
{
    if (piece.arc < 0)
        return false;
    int const made_by = arc(piece).piece;
    return !tooth.pieces[static_cast<std::size_t>(made_by)].corner && !is_tip(tooth, made_by);
}

StudyDrive study_drive(Scene const& scene)
{
    Scene coarse = scene;
    coarse.solver.tolerance = (scene.drive.module) * 0x1p-10;
    Solution const solution = solve(coarse);
    Profile tooth = tooth_of(scene);
    double const ratio = static_cast<double>(scene.drive.flexspline_teeth) / scene.drive.circular_spline_teeth;
    Faults faults;
    AnyWaveShape const shape = build_wave_shape(scene.wave_generator.shape, {solution.geometry.r_m, scene.wave_generator.waves, scene.folder.string()}, faults);
    if (!faults.empty())
        throw InputError(faults);
    StudyMotion motion(NeutralCurve<AnyWaveShape>(shape, solution.geometry.r_m), ratio);
    tooth = clear_of_rest(tooth, motion);
    StudyDrive drive{scene, solution.geometry, std::move(tooth), std::move(motion), {}, {}, 2 * std::numbers::pi / scene.drive.circular_spline_teeth,
                     scene.circular_spline.backlash_offset};
    BranchSet const set = find_branches(drive.envelope(), 1);
    drive.branches = set.branches.size();
    for (Branch const& branch : set.branches)
        drive.arcs.insert(drive.arcs.end(), branch.arcs.begin(), branch.arcs.end());
    Envelope<StudyMotion> const envelope = drive.envelope();
    double const scale = drive.geometry.r_m + drive.geometry.w0 + drive.tooth.pitch_line + drive.tooth.addendum;
    Tolerance const tolerance{scale * 0x1p-44, scale};
    drive.pieces = ToothSpaceFinder<StudyMotion>(envelope, drive.arcs, drive.geometry.circular_spline_inner_radius, scene.drive.circular_spline_teeth,
                                                 tolerance, drive.height() * 0x1p-14)()
                       .pieces;
    return drive;
}

std::vector<double> fold_angles(StudyMotion const& motion, std::vector<CurvePiece> const& pieces)
{
    Profile flank;
    flank.segment_names = {"flank"};
    for (CurvePiece const& piece : pieces)
        flank.pieces.push_back({piece, 0, 0, 1, false});
    std::vector<double> angles;
    for (Branch const& branch : find_branches(Envelope<StudyMotion>(flank, motion, 0), 1).branches)
    {
        for (ContactArc const& arc : branch.arcs)
        {
            if (arc.begins == BranchEnd::double_root)
                angles.push_back(arc.u_begin);
            if (arc.ends == BranchEnd::double_root)
                angles.push_back(arc.u_end);
        }
    }
    std::sort(angles.begin(), angles.end());
    angles.erase(std::unique(angles.begin(), angles.end()), angles.end());
    return angles;
}

double entry_of(StudyDrive const& drive, ReferenceCurve const& reference, int samples, int positions)
{
    GivenMotion<double> const motion(drive.numbers());
    std::vector<Vec2> const tooth = polygon_of(drive.tooth, drive.height() * 0x1p-20);
    PolylineTree const sides(tooth);
    double low = tooth.front().y(), high = low, wide = 0;
    for (Vec2 const& p : tooth)
    {
        low = std::min(low, p.y());
        high = std::max(high, p.y());
        wide = std::max(wide, std::abs(p.x()));
    }
    double const half = drive.motion.half_lobe(), step = 2 * half / positions;
    std::vector<Place<double>> places;
    for (int i = 0; i <= positions; ++i)
        places.push_back(motion.at(-half + step * i));
    auto const in_tooth = [](Place<double> const& place, Vec2 const& p) -> Vec2 {
        Pair<double> const d{p.x() - place.origin.x, p.y() - place.origin.y};
        return {inner(d, place.along), inner(d, place.outward)};
    };
    /// Signed: negative inside.
    auto const distance = [&](Vec2 const& x) {
        if (x.y() > high + wide || std::abs(x.x()) > 3 * wide)
            return std::numeric_limits<double>::infinity();
        double const away = sides.nearest(x, tooth.size() / 2).distance;
        bool inside = false;   // even-odd, closed below the root
        for (std::size_t i = 0; i < tooth.size(); ++i)
        {
            Vec2 const& a = tooth[i];
            Vec2 const& b = tooth[(i + 1) % tooth.size()];
            if ((a.y() > x.y()) != (b.y() > x.y()) && x.x() < a.x() + (x.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
                inside = !inside;
        }
        return inside ? -away : away;
    };
    double worst = 0;
    auto const& points = reference.points();
    std::vector<double> along;
    for (int k = 1; k < samples; ++k)
    {
        Vec2 const p = points[points.size() * static_cast<std::size_t>(k) / static_cast<std::size_t>(samples)];
        bool const land = p.norm() < drive.geometry.circular_spline_inner_radius * (1 + 0x1p-40);
        double nearest = std::numeric_limits<double>::infinity();
        constexpr int neighbours = 3;
        for (int copy = -neighbours; copy <= neighbours; ++copy)
        {
            Vec2 const turned = turned_clockwise(p, -copy * drive.pitch);
            auto const at = [&](double u) { return distance(in_tooth(motion.at(u), turned)); };
            along.assign(places.size(), 0);
            for (std::size_t i = 0; i < places.size(); ++i)
                along[i] = distance(in_tooth(places[i], turned));
            for (std::size_t i = 1; i + 1 < along.size(); ++i)
            {
                if (!(along[i] < std::numeric_limits<double>::infinity()) || along[i] > along[i - 1] || along[i] > along[i + 1])
                    continue;
                double const u = -half + step * static_cast<double>(i);
                double a = u - step, b = u + step;
                constexpr int halvings = 40;
                for (int n = 0; n < halvings; ++n)   // thirds
                {
                    double const c = a + (b - a) / 3, d = b - (b - a) / 3;
                    (at(c) < at(d) ? b : a) = at(c) < at(d) ? d : c;
                }
                nearest = std::min(nearest, at(0.5 * (a + b)));
            }
        }
        nearest -= drive.offset;
        worst = std::max(worst, land ? -nearest : std::abs(nearest));
    }
    return worst;
}

double residual_of(StudyDrive const& drive, Solution const& solution, std::size_t samples)
{
    using Wide = long double;
    GivenMotion<Wide> const motion(drive.numbers());
    std::size_t all = 0;
    for (BranchRecord const& branch : solution.branches)
        all += branch.u.size();
    std::size_t const stride = std::max<std::size_t>(1, all / samples);
    Wide worst = 0;
    std::size_t count = 0;
    for (BranchRecord const& branch : solution.branches)
    {
        if (branch.kind != "regular")
            continue;
        for (std::size_t i = 0; i < branch.u.size(); ++i)
        {
            if (count++ % stride != 0)
                continue;
            for (ProfilePiece const& piece : drive.tooth.pieces)
            {
                double const t = branch.t[i];
                if (piece.segment != branch.segment || piece.corner || t < piece.t_begin || t > piece.t_end)
                    continue;
                Place<Wide> const place = motion.at(branch.u[i]);
                Pair<Wide> const p{branch.point[i].x() - place.origin.x, branch.point[i].y() - place.origin.y};
                Pair<Wide> const x{inner(p, place.along), inner(p, place.outward)};
                Wide const local = (Wide(t) - piece.t_begin) / (Wide(piece.t_end) - piece.t_begin);
                Pair<Wide> n{};
                if (auto const* arc = std::get_if<ArcPiece>(&piece.shape))
                {
                    Pair<Wide> const out = x - pair_of<Wide>(arc->centre);
                    n = (Wide(1) / length(out)) * out;
                }
                else if (auto const* line = std::get_if<LinePiece>(&piece.shape))
                {
                    Pair<Wide> const along = pair_of<Wide>(line->b) - pair_of<Wide>(line->a);
                    n = (Wide(1) / length(along)) * to_left(along);
                }
                else
                {
                    auto const& curve = std::get<CurvePiece>(piece.shape);
                    Pair<Wide> const along{casteljau(bernstein_derivative(curve.x()), local), casteljau(bernstein_derivative(curve.y()), local)};
                    n = (Wide(1) / length(along)) * to_left(along);
                }
                worst = std::max(worst, std::abs(inner(place.turned(n), place.velocity(x))));
                break;
            }
        }
    }
    return static_cast<double>(worst);
}

}  // namespace hdconj::detail
