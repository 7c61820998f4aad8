// SPDX-License-Identifier: GPL-3.0-or-later
#include "turning_drive.hpp"

#include <numbers>
#include <numeric>
#include <utility>

#include "contact/study/place_teeth.hpp"
#include "contact/turn_to_contact.hpp"
#include "hdconj/error.hpp"
#include "load/study/flank_deviation.hpp"
#include "load/study/torque_continuation.hpp"

namespace hdconj::running {
namespace {

double ball_load_of(load::ElasticDrive const& drive, load::Equilibrium const& state)
{
    double const balls = std::accumulate(state.balls.begin(), state.balls.end(), 0.0);
    return drive.response->sectors() * (drive.balls ? balls : state.bearing.sum());
}

}  // namespace

load::Play first_contact(contact::ContactContext const& context, contact::FlankGrid const& flanks,
                         RunningMotion const& motion, double pitches)
{
    auto const [whole, phase] = ring_place(motion, pitches);
    std::optional<contact::FlankDeviation> deviation = load::flank_deviation(context, flanks);
    if (deviation)
        deviation = gone_back(std::move(*deviation), whole);
    contact::ToothPoses const places = contact::tooth_places(context, phase, flanks.z);
    contact::GapField const field(context.tooth, flanks, places, motion.flexspline_teeth, motion.circular_spline_teeth,
                                  phase, deviation ? &*deviation : nullptr);
    GapMap const rest = field.map(0, context.threads);
    auto const turn = [&](GapMap::Flank flank) {
        double const pitch = 2 * std::numbers::pi / motion.circular_spline_teeth;
        return contact::turn_to_contact(field, rest, flank, pitch, context.threads).turn;
    };
    double const right = turn(GapMap::right);
    return {right, deviation ? turn(GapMap::left) : -right};
}

/// The drive at one position.
class TurningDrive::At
{
  public:
    /// @param under_torque  false: only gaps are asked for
    At(TurningDrive const& of, double pitches, bool under_torque)
        : place_(ring_place(of.motion_, pitches)),
          drive_(placed(of, place_.phase, under_torque)),
          problem{*of.context_, drive_, of.problem_.flanks, of.problem_.edges, of.problem_.deviation},
          unloaded(in_place(of.drive_->unloaded))
    {
        if (problem.deviation)
            problem.deviation = gone_back(std::move(*problem.deviation), place_.pitches);
    }
    At(At const&) = delete;
    At& operator=(At const&) = delete;

    /// A drive whose shape stands still while the teeth have gone on along it.
    [[nodiscard]] load::LoadedDrive in_place(load::LoadedDrive drive) const
    {
        drive.shape.places = load::tooth_poses(problem.context, drive_, drive.shape.series, place_.phase);
        drive.found.reset();
        return drive;
    }

  private:
    static load::ElasticDrive placed(TurningDrive const& of, double phase, bool under_torque)
    {
        if (under_torque)
            return load::drive_at(of.drive_->model, *of.context_, of.drive_->grid, phase);
        load::ElasticDrive drive = of.drive_->model.drive;  // gaps do not ask for the wave generator
        drive.phase = phase;
        return drive;
    }

    RingPlace place_;
    load::ElasticDrive drive_;

  public:
    load::LoadProblem problem;
    load::LoadedDrive unloaded;
};

TurningDrive::TurningDrive(contact::ContactContext const& context, load::AssembledDrive const& drive,
                           contact::FlankGrid const& flanks, RunningMotion const& motion, double middle)
    : context_(&context),
      drive_(&drive),
      problem_(load::load_problem(context, drive.model.drive, flanks)),
      motion_(motion),
      middle_(middle)
{
}

load::Play TurningDrive::first_contact(double pitches) const
{
    At const at(*this, pitches, false);
    return load::play_about(at.problem, at.unloaded.shape, middle_);
}

std::vector<Balance> TurningDrive::balances(double pitches, std::vector<double> const& torques,
                                            Balance const* neighbour) const
{
    At const at(*this, pitches, true);
    load::Play const play = load::play_about(at.problem, at.unloaded.shape, middle_);
    std::optional<load::TorqueContinuation> path;
    auto const from_first_contact = [&](load::LoadedDrive const* before, double torque) {
        if (!path)
            path.emplace(load::torque_continuation(at.problem, at.unloaded, play));
        return load::advance(*path, before != nullptr ? *before : path->start, torque);
    };
    std::vector<Balance> found;
    for (double const torque : torques) {
        Balance balance;
        std::optional<load::LoadedDrive> near;
        if (found.empty() && neighbour != nullptr) {
            try {
                near = load::converged_at(at.problem, torque, at.in_place(neighbour->drive));
            } catch (NumericalError const& error) {
                if (error.code() != ErrorCode::not_converged && error.code() != ErrorCode::overload)
                    throw;  // the way from the first contact on may still lead there
            }
        }
        balance.drive =
            near ? std::move(*near) : from_first_contact(found.empty() ? nullptr : &found.back().drive, torque);
        balance.sliding = sliding_contacts(at.problem, balance.drive);
        balance.wave_generator_torque = load::loaded_state(at.problem, balance.drive, 0).wave_generator_torque;
        double const lead = static_cast<double>(motion_.circular_spline_teeth - motion_.flexspline_teeth);
        balance.torque_by_teeth = torque * lead / motion_.circular_spline_teeth;
        for (SlidingContact const& each : balance.sliding)
            balance.torque_by_teeth += motion_.cup_rate() * each.force * each.opening;
        balance.ball_load = ball_load_of(at.problem.drive, balance.drive.state);
        found.push_back(std::move(balance));
    }
    return found;
}

double TurningDrive::assembled_ball_load() const
{
    return ball_load_of(drive_->model.drive, drive_->unloaded.state);
}

}  // namespace hdconj::running
