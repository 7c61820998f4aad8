// SPDX-License-Identifier: GPL-3.0-or-later
#include "tooth_bending.hpp"

#include <algorithm>
#include <cmath>

#include "hertz.hpp"

namespace hdconj::load {
namespace {

/// Half the thickness of the tooth at height y: largest x of its outline there, from a fine polygon.
double half_thickness(std::vector<Vec2> const& polygon, double y)
{
    double widest = 0;
    for (std::size_t i = 0; i + 1 < polygon.size(); ++i) {
        Vec2 const& a = polygon[i];
        Vec2 const& b = polygon[i + 1];
        if ((a.y() - y) * (b.y() - y) > 0 || a.y() == b.y())
            continue;
        widest = std::max(widest, std::abs(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x())));
    }
    return widest;
}

}  // namespace

ToothBending::ToothBending(profile::Profile const& tooth, elastic::Elasticity const& material, double chord)
{
    constexpr std::size_t parts = 200;
    std::vector<Vec2> const polygon = profile::polygon_of(tooth, chord);
    foot_ = std::min(polygon.front().y(), polygon.back().y());
    step_ = (tooth.pitch_line + tooth.addendum - foot_) / static_cast<double>(parts);
    double const nu = material.poissons_ratio;
    double m0 = 0, m1 = 0, m2 = 0, shears = 0;
    for (std::size_t i = 0; i < parts; ++i) {
        moment0_.push_back(m0);
        moment1_.push_back(m1);
        moment2_.push_back(m2);
        shears_.push_back(shears);
        double const low = static_cast<double>(i) * step_, high = low + step_;
        double const s = 2 * half_thickness(polygon, foot_ + 0.5 * (low + high));
        bend_.push_back(s > 0 ? 12 / (plane_strain_modulus(material) * s * s * s) : 0);
        shear_.push_back(s > 0 ? 2.4 * (1 + nu) / (material.youngs_modulus * s) : 0);
        m0 += bend_[i] * step_;
        m1 += bend_[i] * (high * high - low * low) / 2;
        m2 += bend_[i] * (high * high * high - low * low * low) / 3;
        shears += shear_[i] * step_;
    }
}

double ToothBending::operator()(double h, double k) const
{
    if (bend_.empty())
        return 0;
    double const top = step_ * static_cast<double>(bend_.size());
    h = std::clamp(h - foot_, 0.0, top);
    k = std::clamp(k - foot_, 0.0, top);
    double const end = std::min(h, k);
    std::size_t const i = std::min(static_cast<std::size_t>(end / step_), bend_.size() - 1);
    double const low = static_cast<double>(i) * step_;
    double const m0 = moment0_[i] + bend_[i] * (end - low);
    double const m1 = moment1_[i] + bend_[i] * (end * end - low * low) / 2;
    double const m2 = moment2_[i] + bend_[i] * (end * end * end - low * low * low) / 3;
    return h * k * m0 - (h + k) * m1 + m2 + shears_[i] + shear_[i] * (end - low);
}

}  // namespace hdconj::load
