// SPDX-License-Identifier: GPL-3.0-or-later
// Directions in which gaps change where flanks deviate.
#include "gap_field.hpp"

namespace hdconj::contact {
namespace {

/// Step of derivatives, of the pitch: the truncation goes with its square, the rounding with its inverse.
constexpr double derivative_step = 1e-5;

}  // namespace

/// Gradient of distance and deviation at @p x, whose distance has the gradient @p normal. Along the normal the nearest
/// point stays.
Vec2 GapField::deviating_normal(Vec2 const& x, Vec2 const& normal) const
{
    double const h = derivative_step * pitch_ * reach_;
    Vec2 const along = left_of(normal);
    auto const at = [&](double way) { return deviation_->height(distance_(x + way * along).point.y()); };
    return (normal + (at(h) - at(-h)) / (2 * h) * along).normalized();
}

Vec2 GapField::rise(Vec2 const& q) const
{
    if (!deviation_ || !deviation_->radius)
        return Vec2::Zero();
    double const h = derivative_step * pitch_ * reach_, r = q.norm();
    return (deviation_->radius(r + h) - deviation_->radius(r - h)) / (2 * h) * q / r;
}

}  // namespace hdconj::contact
