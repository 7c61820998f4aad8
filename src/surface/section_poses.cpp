// SPDX-License-Identifier: GPL-3.0-or-later
#include "section_poses.hpp"

#include "hdconj/motion/parameter_at.hpp"

namespace hdconj::surface {

SectionPoses::SectionPoses(double low, double high, double tooth_ratio, MotionOf const& motion_of, int count)
    : ratio_(tooth_ratio)
{
    for (int j = 0; j < count; ++j) {
        double const x = std::cos(std::numbers::pi * (j + 0.5) / count);
        factor_.push_back(0.5 * (low + high) + 0.5 * (high - low) * x);
        motion_.push_back(motion_of(factor_.back()));
    }
}

SectionPoses::Sample SectionPoses::sample(motion::AnyMotion const& motion, double phi) const
{
    double const u = motion::parameter_at(motion, phi);
    Pose const pose = motion.pose(u);
    // only the direction of the tangent counts, and this rate scales the small part of it
    constexpr double step = 0x1p-16;
    double const phi_rate = (motion.angles(u + step).phi - motion.angles(u - step).phi) / (2 * step);
    Vec2 const velocity = pose.rotate(motion.rates(u).twist.q) / phi_rate;
    return {std::atan2(pose.sine, pose.cosine), pose.origin, velocity + ratio_ * right_of(pose.origin)};
}

Pose SectionPoses::operator()(double phi, double factor, double factor_slope) const
{
    Sample whole{0, Vec2::Zero(), Vec2::Zero()};
    Vec2 with_factor = Vec2::Zero();  // dP/df
    for (std::size_t j = 0; j < factor_.size(); ++j) {
        double weight = 1;
        double slope = 0;
        for (std::size_t i = 0; i < factor_.size(); ++i) {
            if (i == j)
                continue;
            double const width = factor_[j] - factor_[i];
            slope = slope * (factor - factor_[i]) / width + weight / width;
            weight *= (factor - factor_[i]) / width;
        }
        Sample const at = sample(motion_[j], phi);
        whole.theta += weight * at.theta;
        whole.origin += weight * at.origin;
        whole.tangent += weight * at.tangent;
        with_factor += slope * at.origin;
    }
    Vec2 const tangent = whole.tangent + factor_slope * with_factor;
    double const turned = std::atan2(cross(whole.tangent, tangent), whole.tangent.dot(tangent));
    double const theta = whole.theta - turned;
    return {std::cos(theta), std::sin(theta), whole.origin};
}

}  // namespace hdconj::surface
