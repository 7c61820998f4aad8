// SPDX-License-Identifier: GPL-3.0-or-later
// The outlines of a tilted surface: that of the middle, drafted or not.
#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "hdconj/error.hpp"
#include "slice_job.hpp"
#include "tooth_surface.hpp"

namespace hdconj::surface {

std::shared_ptr<conjugate::ToothSpaceBoundary const> ToothSurfaceBuilder::middle_beyond(double tip, double smaller)
{
    prepare_middle();
    auto const tried = [&](double radius) -> std::shared_ptr<conjugate::ToothSpaceBoundary const> {
        try {
            return middle_job_->boundary(radius);
        } catch (NumericalError const& error) {
            error.rethrow_unless_infeasible();
            return nullptr;
        }
    };
    auto const with_land = [&] { return middle_job_->pointed ? *middle_job_->pointed + 4 * tolerance_.length : 0.0; };
    if (auto const found = tried(std::min(tip, std::max(smaller, with_land()))); found || !(smaller < tip))
        return found ? found : middle_job_->boundary(tip);
    middle_job_->pointed = middle_job_->solve->pointed_radius(smaller);
    auto const found = smaller < with_land() && with_land() < tip ? tried(with_land()) : nullptr;
    return found ? found : middle_job_->boundary(tip);
}

conjugate::MatchedOutline ToothSurfaceBuilder::one_outline(SurfaceSpec const& spec, double tip, double chord,
                                                           int flank_intervals)
{
    prepare_middle();
    auto const boundary = middle_job_->boundary(tip);
    conjugate::ToothSpaceBoundary const& base = *boundary;
    if (!spec.is_drafted() || z_.size() == 1) {
        conjugate::MatchedOutline outline = conjugate::matched_outline({&base}, chord, flank_intervals, threads_);
        outline.points.resize(z_.size(), outline.points.front());
        outline.normals.resize(z_.size(), outline.normals.front());
        return outline;
    }
    std::vector<conjugate::ToothSpaceBoundary> moved;
    std::vector<conjugate::ToothSpaceBoundary const*> slices;
    moved.reserve(z_.size());
    double const furthest_in = std::min(z_.front() * std::tan(spec.tilt), z_.back() * std::tan(spec.tilt));
    auto const beyond = middle_beyond(tip, tip + furthest_in);
    for (double const z : z_)
        in_slice(z, [&] {
            double const distance = z * std::tan(spec.tilt);
            moved.push_back(
                distance < 0 ? beyond->cut_at(tip + distance).moved_along_normal(distance, tolerance_, tip + distance)
                             : base.moved_along_normal(distance, tolerance_));
        });
    for (conjugate::ToothSpaceBoundary const& curve : moved)
        slices.push_back(&curve);
    return conjugate::matched_outline(slices, chord, flank_intervals, threads_);
}

}  // namespace hdconj::surface
