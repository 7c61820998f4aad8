// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <algorithm>
#include <limits>
#include <numbers>

#include "clearance.hpp"
#include "closed_curve.hpp"
#include "completion.hpp"
#include "drive/stage_clock.hpp"
#include "drive/wanted_geometry.hpp"
#include "hdconj/base/parallel.hpp"
#include "hdconj/base/tolerance.hpp"
#include "hdconj/check.hpp"
#include "hdconj/units.hpp"
#include "hdconj/wanted_curve.hpp"
#include "judgement/checks.hpp"

namespace hdconj::cam {
namespace {

constexpr int half_wave_rows = 180;  ///< rows of half a wave
constexpr std::size_t fewest = 6;    ///< rows in mesh of which a second derivative is taken
constexpr double no_error = std::numeric_limits<double>::quiet_NaN();

/// The curve where flanks touch, and how it begins.
struct Mesh
{
    MeshBegin begin;
    MarchedCurve curve;
    std::size_t first = 0;  ///< row of curve.points.front()
};

class Search
{
  public:
    Search(WantedCurve& out, drive::GivenPair const& given, drive::StageClock& clock)
        : out_(out), given_(given), clock_(clock), waves_(out.scene.wave_generator.waves)
    {
        Scene const& scene = out.scene;
        rule_ = {given.geometry.r_m,
                 static_cast<double>(scene.drive.flexspline_teeth) / scene.drive.circular_spline_teeth,
                 scene.solver.kinematics == Kinematics::exact};
        half_wave_ = std::numbers::pi / waves_;
        // some roundings of the tooth's size
        rounding_ = 16 * unit_roundoff * (given.flexspline.addendum + given.flexspline.dedendum);
    }

    void operator()()
    {
        clock_.run(Stage::neutral_curve, [&] {
            FlankPair const pair = flanks(0);
            choose_major(pair);
            Mesh const mesh = mesh_of(pair, out_.major_displacement, rounding_);
            fill_rows(mesh);
            fill_errors(mesh);
            close(pair);
        });
        clock_.run(Stage::interference, [&] { check_turn(); });
    }

  private:
    [[nodiscard]] FlankPair flanks(double offset) const
    {
        double const half_pitch = std::numbers::pi / out_.scene.drive.circular_spline_teeth;
        return {Flank(given_.flexspline), Flank(given_.circular_spline),
                right_wall(half_pitch, rule_.r_m, given_.seat_height), offset};
    }

    void choose_major(FlankPair const& pair)
    {
        auto const told = out_.scene.wave_generator.shape.number("major_displacement");
        out_.major_displacement = told ? *told : deepest_displacement(pair, rule_, given_.deepest);
        if (told && *told > given_.root_limit)
            out_.notes.push_back(
                fmt::format("the flexspline's tips reach {:.4g} mm beyond the roots of the given "
                            "circular-spline teeth: the space has to be that much deeper",
                            *told - given_.root_limit));
        out_.major_error = told ? 0 : out_.scene.solver.tolerance;
    }

    [[nodiscard]] double angle(std::size_t row) const { return half_wave_ * static_cast<double>(row) / half_wave_rows; }

    [[nodiscard]] Mesh mesh_of(FlankPair const& pair, double major, double tolerance) const
    {
        Mesh mesh{mesh_begin(pair, rule_, waves_, major, half_wave_ / 2, tolerance), {}, 0};
        while (mesh.first < half_wave_rows && angle(mesh.first) < mesh.begin.point.x)
            ++mesh.first;
        std::vector<double> angles;
        for (std::size_t i = mesh.first; i <= half_wave_rows; ++i)
            angles.push_back(angle(i));
        mesh.curve = march(pair, rule_, mesh.begin.point, angles, tolerance);
        if (mesh.curve.points.size() < fewest)
            throw NumericalError(
                ErrorCode::no_contact, "neutral curve", fmt::format("u = {:.6g} deg", to_deg(mesh.curve.last.x)),
                fmt::format("the flanks stop touching there, {:.3g} deg after they began: {}",
                            to_deg(mesh.curve.last.x - mesh.begin.point.x), why_parted(pair, mesh.curve.last)),
                "give teeth that are conjugate to each other on some neutral curve, or another "
                "wave_generator.major_displacement");
        return mesh;
    }

    /// Which end of a flank the contact has reached.
    [[nodiscard]] std::string why_parted(FlankPair const& pair, CurvePoint const& last) const
    {
        double const near = 1e-3 * pair.inner().length();
        struct End
        {
            double distance;
            char const* name;
        };
        End const ends[] = {
            {pair.inner().from_tip(last.contact.inner), "the tip end of the flexspline's flank"},
            {pair.inner().from_root(last.contact.inner), "the root end of the flexspline's flank"},
            {pair.outer().from_tip(last.contact.outer), "the tip end of the circular spline's flank"},
            {pair.outer().from_root(last.contact.outer), "the root end of the circular spline's flank"}};
        for (End const& end : ends)
            if (end.distance < near)
                return std::string("contact reaches ") + end.name;
        return "no place of the tooth beyond lets the flanks touch without overlap";
    }

    void fill_rows(Mesh const& mesh)
    {
        std::vector<CurvePoint> const& points = mesh.curve.points;
        std::size_t const last = mesh.first + points.size() - 1;
        EvenPolynomial rest;
        if (last < half_wave_rows) {
            double const h = half_wave_ / half_wave_rows;
            auto const slope = [&](std::size_t back) { return points[points.size() - 1 - back].slope; };
            // one-sided difference of order four
            double const bend =
                (25 * slope(0) - 48 * slope(1) + 36 * slope(2) - 16 * slope(3) + 3 * slope(4)) / (12 * h);
            rest = completion(rule_, points.back(), bend, half_wave_);
        }
        for (std::size_t i = 0; i <= half_wave_rows; ++i) {
            double const u = angle(i);
            bool const before = i<mesh.first, beyond = i> last;
            if (before || beyond) {
                EvenPolynomial::Value const at = before ? mesh.begin.to_axis(u) : rest(half_wave_ - u);
                out_.rows.push_back({u, at.value, before ? at.slope : -at.slope, 0, no_error, false});
            } else {
                CurvePoint const& point = points[i - mesh.first];
                out_.rows.push_back({u, point.state[0], point.slope, 0, 0, true});
            }
        }
        out_.touch_begin = mesh.begin.first;
        out_.touch_end = mesh.curve.last.x;
        out_.ends = mesh.curve.lost ? why_parted(flanks(0), mesh.curve.last) : "the flanks touch up to the minor axis";
    }

    /// What a flank that is moved outward by a little does to the curve, per length.
    void fill_errors(Mesh const& mesh)
    {
        out_.flank_error = out_.scene.solver.tolerance;
        double const probe = 0x1p-24 * out_.flank_error;
        Mesh const moved = mesh_of(flanks(probe), out_.major_displacement, rounding_);
        Mesh const coarse = mesh_of(flanks(0), out_.major_displacement, 64 * rounding_);
        auto const state_at = [](Mesh const& of, std::size_t row) {
            std::size_t const i = row - of.first;
            return row >= of.first && i < of.curve.points.size() ? std::optional(of.curve.points[i].state[0])
                                                                 : std::nullopt;
        };
        for (std::size_t i = mesh.first; i < mesh.first + mesh.curve.points.size(); ++i) {
            WantedCurveRow& row = out_.rows[i];
            auto const other = state_at(moved, i), same = state_at(coarse, i);
            double const growth = other ? std::abs(*other - row.displacement) / probe : out_.growth;
            out_.growth = std::max(out_.growth, growth);
            row.error = out_.growth * out_.flank_error + (same ? std::abs(*same - row.displacement) : 0);
            out_.error = std::max(out_.error, row.error);
        }
        auto const end_error = [&](Mesh const& of) { return std::abs(of.curve.last.x - out_.touch_end); };
        out_.touch_end_error =
            mesh.curve.lost ? end_error(moved) / probe * out_.flank_error + end_error(coarse) + mesh.curve.end_error
                            : 0;
        out_.touch_begin_error =
            std::abs(moved.begin.first - out_.touch_begin) * (out_.flank_error / probe) + mesh.begin.first_error;
    }

    void close(FlankPair const& pair)
    {
        std::vector<double> displacement, thinned;
        for (std::size_t i = 0; i <= half_wave_rows; ++i) {
            displacement.push_back(out_.rows[i].displacement);
            if (i % 2 == 0)
                thinned.push_back(out_.rows[i].displacement);
        }
        ClosedCurve const curve(rule_, waves_, displacement);
        ClosedCurve const coarse(rule_, waves_, thinned);
        fill_curvature(curve, coarse);
        out_.geometry.r_0 = curve.r_0();
        out_.geometry.w0 = curve.amplitude();
        double const raised = curve(0).state[0] - out_.rows.front().displacement;
        out_.length_error = 2 * std::numbers::pi * raised;
        for (std::size_t i = 0; i < half_wave_rows; ++i) {
            if (!out_.rows[i].touching || !out_.rows[i + 1].touching)
                continue;
            double const u = (angle(i) + angle(i + 1)) / 2;
            ClosedCurve::Place const at = curve(u), near = coarse(u);
            auto const gap = gap_at(pair, u, at), other = gap_at(pair, u, near);
            if (gap)
                out_.residual = std::max(out_.residual, std::abs(*gap));
            if (gap && other)
                // a quarter of the step: an error of a cubic spline 16 times smaller, of which half may be left
                out_.residual_error = std::max(out_.residual_error, std::abs(*other - *gap) / 8);
        }
        out_.residual_error += 64 * unit_roundoff * rule_.r_m;
        outlines(curve);
    }

    [[nodiscard]] std::optional<double> gap_at(FlankPair const& pair, double u, ClosedCurve::Place const& at) const
    {
        ToothOrigin const origin = rule_.origin(u, at.state);
        double const theta = rule_.theta(origin, at.slope);
        std::vector<Tangency> const found = pair.tangencies(origin, theta);
        if (found.empty())
            return std::nullopt;
        return (found.front().theta - theta) * found.front().lever;
    }

    void fill_curvature(ClosedCurve const& curve, ClosedCurve const& coarse)
    {
        out_.least_curvature = std::numeric_limits<double>::infinity();
        out_.largest_curvature = -out_.least_curvature;
        double where = 0, bent = 0;
        for (WantedCurveRow& row : out_.rows) {
            row.curvature = curve.curvature(row.u);
            if (row.curvature < out_.least_curvature)
                where = row.u;
            out_.least_curvature = std::min(out_.least_curvature, row.curvature);
            out_.largest_curvature = std::max(out_.largest_curvature, row.curvature);
            bent = std::max(bent, std::abs(row.curvature - 1 / rule_.r_m));
            // second derivatives of cubic splines: half the step, a quarter of the error
            out_.curvature_error =
                std::max(out_.curvature_error, std::abs(coarse.curvature(row.u) - row.curvature) / 2);
        }
        if (!(out_.least_curvature > 0))
            throw NumericalError(ErrorCode::no_solution, "neutral curve", fmt::format("u = {:.4g} deg", to_deg(where)),
                                 fmt::format("the closed curve would be hollow there; flanks touch from {:.4g} to "
                                             "{:.4g} deg, where {}",
                                             to_deg(out_.touch_begin), to_deg(out_.touch_end), out_.ends),
                                 "write another wave_generator.major_displacement, or give teeth that are conjugate to "
                                 "each other over a longer stretch");
        double const stress = judgement::stress_of_bending(out_.scene);
        out_.bending_stress = stress * bent;
        out_.stress_error = stress * out_.curvature_error;
    }

    void outlines(ClosedCurve const& curve)
    {
        Flexspline const& flexspline = out_.scene.flexspline;
        out_.inner_distance = out_.scene.wave_generator.shape.number("inner_distance")
                                  .value_or(out_.geometry.r_m - out_.geometry.flexspline_inner_radius);
        static_cast<void>(flexspline);
        if (!(out_.inner_distance * out_.largest_curvature < 1))
            out_.notes.push_back(
                "the parallel curve at wave_generator.inner_distance folds over itself: the neutral "
                "curve is bent more sharply than that");
        int const points = 2 * half_wave_rows * waves_;
        for (int i = 0; i < points; ++i) {
            double const u = 2 * std::numbers::pi * i / points;
            ClosedCurve::Place const at = curve(u);
            double const polar = rule_.exact ? u : u + at.state[1] / rule_.r_m;
            double const rho = rule_.r_m + at.state[0];
            double const normal = polar - (rule_.exact ? std::atan2(at.slope, rho) : at.slope / rule_.r_m);
            Vec2 const p = rho * Vec2(std::sin(polar), std::cos(polar));
            out_.neutral_curve.push_back(p);
            out_.inner_surface.push_back(p - out_.inner_distance * Vec2(std::sin(normal), std::cos(normal)));
        }
    }

    void check_turn()
    {
        std::vector<double> displacement;
        for (WantedCurveRow const& row : out_.rows)
            displacement.push_back(row.displacement);
        ClosedCurve const curve(rule_, waves_, displacement);
        LeastClearance const least = least_clearance(given_, rule_, curve, out_.scene, out_.threads);
        out_.smallest_clearance = least.clearance;
        out_.clearance_u = least.u;
        out_.clearance_error = least.error;
        if (least.clearance < -out_.scene.solver.tolerance - least.error)
            out_.notes.push_back(
                fmt::format("both teeth overlap by {:.3g} mm at u = {:.4g} deg, {} the stretch where "
                            "their flanks touch",
                            -least.clearance, to_deg(least.u),
                            least.u > out_.touch_end || least.u < out_.touch_begin ? "outside" : "on"));
    }

    WantedCurve& out_;
    drive::GivenPair const& given_;
    drive::StageClock& clock_;
    int waves_;
    CurveRule rule_;
    double half_wave_ = 0;
    double rounding_ = 0;
};

}  // namespace
}  // namespace hdconj::cam

namespace hdconj {

WantedCurve find_neutral_curve(Scene const& scene, StageObserver const& on_stage)
{
    if (Faults const faults = check_wanted_scene(scene); !faults.empty())
        throw InputError(faults);
    WantedCurve out;
    out.scene = scene;
    out.plan = make_plan(scene);
    out.threads = thread_count(scene.solver.threads);
    drive::StageClock clock(out.plan, on_stage);
    drive::GivenPair given;
    clock.run(Stage::profile, [&] {
        Faults faults;
        given = drive::given_pair(scene, faults);
        out.geometry = given.geometry;
    });
    cam::Search(out, given, clock)();
    out.timing = clock.times();
    return out;
}

}  // namespace hdconj
