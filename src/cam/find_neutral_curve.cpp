// SPDX-License-Identifier: GPL-3.0-or-later
// Long: one search, whose steps fill one curve and its errors.
#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <limits>
#include <numbers>

#include "clearance.hpp"
#include "closed_curve.hpp"
#include "drive/stage_clock.hpp"
#include "drive/wanted_geometry.hpp"
#include "hdconj/base/parallel.hpp"
#include "hdconj/base/tolerance.hpp"
#include "hdconj/check.hpp"
#include "hdconj/error.hpp"
#include "hdconj/scene/reading.hpp"
#include "hdconj/units.hpp"
#include "hdconj/wanted_curve.hpp"
#include "judgement/checks.hpp"
#include "mesh.hpp"

namespace hdconj::cam {
namespace {

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
        out.flank_error = scene.solver.tolerance;
        // some roundings of the tooth's size
        rounding_ = 16 * unit_roundoff * (given.flexspline.addendum + given.flexspline.dedendum);
    }

    void operator()()
    {
        std::array<WantedCurve, 3> moved;
        clock_.run(Stage::neutral_curve, [&] {
            choose_major(flanks(0));
            Mesh const mesh = find_given();
            fill_errors(mesh);
            MeshBegin const other = mesh.begin.shifted(1);
            parallel_for(moved.size(), out_.threads, 1, [&](std::size_t i) {
                moved[i] = i == 2 ? moved_by(0, &other) : moved_by(i == 0 ? -out_.flank_error : out_.flank_error);
            });
        });
        clock_.run(Stage::interference, [&] { check_turn(); });
        for (WantedCurve const& other : moved)
            add_difference(
                other, &other == &moved.back()
                           ? "a beginning that is moved by its error gives"
                           : fmt::format("flanks that are moved by their error, {:.2g} mm, give", out_.flank_error));
    }

  private:
    [[nodiscard]] FlankPair flanks(double offset) const
    {
        double const half_pitch = std::numbers::pi / out_.scene.drive.circular_spline_teeth;
        return {Flank(given_.flexspline), Flank(given_.circular_spline),
                right_wall(half_pitch, rule_.r_m, given_.seat_height), offset};
    }

    /// The closed curve of flanks that are moved outward by @p offset.
    /// @param begin  where it is known
    Mesh find(double offset, MeshBegin const* begin = nullptr)
    {
        FlankPair const pair = flanks(offset);
        Mesh mesh = begin != nullptr ? mesh_from(*begin, pair, rule_, waves_, rounding_)
                                     : mesh_of(pair, rule_, waves_, out_.major_displacement, rounding_);
        fill_rows(pair, mesh);
        close(pair);
        return mesh;
    }

    /// Of the given flanks. Where none is found for the displacement that the program chose, how it did is told.
    Mesh find_given()
    try {
        return find(0);
    } catch (NumericalError const& failure) {
        if (out_.major_error == 0 || out_.major_displacement != given_.root_limit)
            throw;
        throw NumericalError(
            failure.code(), failure.stage(), failure.place(),
            failure.cause() +
                "; the displacement is not given, so the flexspline's tips were taken to the roots of the "
                "given circular-spline teeth",
            fmt::format("write wave_generator.major_displacement, more than {:.6g} where the points of the circular "
                        "spline's tooth end before its root; or teeth that are conjugate to each other over a longer "
                        "stretch",
                        given_.root_limit));
    }

    /// A curve of its own for flanks that are moved outward by @p offset, or another @p begin; without rows where they
    /// have none.
    [[nodiscard]] WantedCurve moved_by(double offset, MeshBegin const* begin = nullptr) const
    {
        WantedCurve moved;
        moved.scene = out_.scene;
        moved.geometry = out_.geometry;
        moved.major_displacement = out_.major_displacement;
        Search search(moved, given_, clock_);
        try {
            search.find(offset, begin);
            search.check_turn();
        } catch (NumericalError const& error) {
            error.rethrow_unless_infeasible();
            moved.rows.clear();
        }
        return moved;
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

    [[nodiscard]] double angle(std::size_t row) const { return row_angle(row, waves_); }

    void fill_rows(FlankPair const& pair, Mesh const& mesh)
    {
        MeshClosing const closing = closing_of(pair, rule_, waves_, out_.major_displacement, mesh);
        std::size_t const last = closing.last;
        out_.rows = closed_rows(mesh, closing, waves_);
        out_.touch_begin = mesh.begin.first;
        bool const whole = last == mesh.last();
        out_.touch_end = whole ? mesh.curve.last.x : angle(last);
        out_.parting = mesh.curve.last.x;
        out_.ends = mesh.curve.lost ? why_parted(pair, mesh.curve.last) : "the flanks touch up to the minor axis";
        if (!whole)
            out_.notes.push_back(fmt::format(
                "the closed curve leaves the flanks at {:.4g} deg: farther on it would be hollow, or bent more than "
                "{:g} times as a cosine of the same displacement",
                to_deg(out_.touch_end), most_bending));
    }

    /// What a flank that is moved outward by a little does to the curve, per length, and what the error of its
    /// beginning does.
    void fill_errors(Mesh const& mesh)
    {
        // far above rounding, and still small when it has grown a million times
        double const probe = 0x1p-34 * (given_.flexspline.addendum + given_.flexspline.dedendum);
        Mesh const moved = mesh_of(flanks(probe), rule_, waves_, out_.major_displacement, rounding_);
        Mesh const coarse = mesh_of(flanks(0), rule_, waves_, out_.major_displacement, 64 * rounding_);
        double const shift = std::hypot(mesh.begin.shift[0], mesh.begin.shift[1]);
        double const share = shift > probe ? probe / shift : 1;
        Mesh const begun = shift > 0 ? mesh_from(mesh.begin.shifted(share), flanks(0), rule_, waves_, rounding_) : mesh;
        double by_begin = 0;
        auto const state_at = [](Mesh const& of, std::size_t row) {
            std::size_t const i = row - of.first;
            return row >= of.first && i < of.curve.points.size() ? std::optional(of.curve.points[i].state[0])
                                                                 : std::nullopt;
        };
        for (std::size_t i = mesh.first; i < out_.rows.size() && out_.rows[i].touching; ++i) {
            WantedCurveRow& row = out_.rows[i];
            auto const other = state_at(moved, i), same = state_at(coarse, i), later = state_at(begun, i);
            double const growth = other ? std::abs(*other - row.displacement) / probe : out_.growth;
            out_.growth = std::max(out_.growth, growth);
            by_begin = std::max(by_begin, later ? std::abs(*later - row.displacement) / share : 0);
            row.error = out_.growth * out_.flank_error + by_begin + (same ? std::abs(*same - row.displacement) : 0);
            out_.error = std::max(out_.error, row.error);
        }
        auto const end_error = [&](Mesh const& of) { return std::abs(of.curve.last.x - out_.parting); };
        out_.parting_error = mesh.curve.lost ? end_error(moved) / probe * out_.flank_error + end_error(begun) / share +
                                                   end_error(coarse) + mesh.curve.end_error
                                             : 0;
        out_.touch_end_error = out_.touch_end == out_.parting ? out_.parting_error : 0;
        out_.touch_begin_error =
            std::abs(moved.begin.first - out_.touch_begin) * (out_.flank_error / probe) + mesh.begin.first_error;
    }

    /// The closed curve through every @p stride-th row.
    [[nodiscard]] ClosedCurve curve_of_rows(std::size_t stride) const
    {
        std::vector<double> displacement;
        for (std::size_t i = 0; i < out_.rows.size(); i += stride)
            displacement.push_back(out_.rows[i].displacement);
        return {rule_, waves_, displacement};
    }

    void close(FlankPair const& pair)
    {
        ClosedCurve const curve = curve_of_rows(1), coarse = curve_of_rows(2);
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
            auto const gap = gap_at(pair, rule_, u, at), other = gap_at(pair, rule_, u, near);
            if (gap)
                out_.residual = std::max(out_.residual, std::abs(*gap));
            if (gap && other)
                // a quarter of the step: an error of a cubic spline 16 times smaller, of which half may be left
                out_.residual_error = std::max(out_.residual_error, std::abs(*other - *gap) / 8);
        }
        out_.residual_error += 64 * unit_roundoff * rule_.r_m;
        draw(curve);
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

    void draw(ClosedCurve const& curve)
    {
        out_.inner_distance = out_.scene.wave_generator.shape.number("inner_distance")
                                  .value_or(out_.geometry.r_m - out_.geometry.flexspline_inner_radius);
        if (!(out_.inner_distance * out_.largest_curvature < 1))
            out_.notes.push_back(
                "the parallel curve at wave_generator.inner_distance folds over itself: the neutral curve is bent more "
                "sharply");
        int const points = 2 * static_cast<int>(half_wave_rows) * waves_;
        out_.neutral_curve = curve.outline(points, 0);
        out_.inner_surface = curve.outline(points, out_.inner_distance);
    }

    void check_turn()
    {
        LeastClearance const least = least_clearance(given_, rule_, curve_of_rows(1), out_.scene, out_.threads);
        out_.smallest_clearance = least.clearance;
        out_.clearance_u = least.u;
        out_.clearance_error = least.error;
        if (least.clearance < -out_.scene.solver.tolerance - least.error)
            out_.notes.push_back(fmt::format(
                "both teeth overlap by {:.3g} mm at u = {:.4g} deg, {} the stretch where their flanks touch",
                -least.clearance, to_deg(least.u),
                least.u > out_.touch_end || least.u < out_.touch_begin ? "outside" : "on"));
    }

    /// Where a curve leaves its flanks and closes is no smooth function of them: their error moves these figures by as
    /// much as the curve of @p moved flanks differs. The beginning likewise.
    /// @param moves  what was moved, and a verb
    void add_difference(WantedCurve const& moved, std::string const& moves)
    {
        constexpr double safety = 1.5;  // two samples of what their error may do
        auto const difference = [&](double WantedCurve::*figure) {
            return moved.rows.empty() ? std::numeric_limits<double>::infinity()
                                      : safety * std::abs(moved.*figure - out_.*figure);
        };
        auto const raise = [](double& error, double to) { error = std::max(error, to); };
        raise(out_.touch_end_error, difference(&WantedCurve::touch_end));
        raise(out_.curvature_error, difference(&WantedCurve::least_curvature));
        raise(out_.curvature_error, difference(&WantedCurve::largest_curvature));
        raise(out_.stress_error, difference(&WantedCurve::bending_stress));
        raise(out_.clearance_error, difference(&WantedCurve::smallest_clearance));
        if (moved.rows.empty())
            out_.notes.push_back(moves + " no closed curve: curvature, stress and clearance are not determined");
    }

    WantedCurve& out_;
    drive::GivenPair const& given_;
    drive::StageClock& clock_;
    int waves_;
    CurveRule rule_;
    double rounding_ = 0;
};

}  // namespace
}  // namespace hdconj::cam

namespace hdconj {

WantedCurve find_neutral_curve(Scene const& scene, StageObserver const& on_stage)
{
    throw_if_any(scene::value_faults(scene));
    throw_if_any(check_wanted_scene(scene));
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
