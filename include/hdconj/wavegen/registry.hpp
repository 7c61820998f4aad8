// SPDX-License-Identifier: GPL-3.0-or-later
// The wave generator families by name.
#pragma once

#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "hdconj/error.hpp"
#include "hdconj/scene/parameters.hpp"
#include "hdconj/wavegen/build.hpp"
#include "hdconj/wavegen/cosine_cam.hpp"
#include "hdconj/wavegen/ellipse_cam.hpp"
#include "hdconj/wavegen/four_roller.hpp"
#include "hdconj/wavegen/ring_on_cam.hpp"
#include "hdconj/wavegen/table_cam.hpp"
#include "hdconj/wavegen/two_disc.hpp"

namespace hdconj::wavegen {

/// Any registered wave generator shape, itself a WaveShape. Motions are compiled once for all families. Choosing the
/// family at each angle costs a jump beside the sine and cosine that follow.
class AnyWaveShape
{
  public:
    using Families = std::variant<CosineCam, EllipseCam, FourRoller, TwoDisc, TableCam, RingOnCam>;

    AnyWaveShape() = default;
    template <WaveShape Shape>
    requires(!std::same_as<Shape, AnyWaveShape>) explicit AnyWaveShape(Shape shape) : shape_(std::move(shape)) {}

    [[nodiscard]] Families const& family() const { return shape_; }
    [[nodiscard]] int waves() const
    {
        return std::visit([](auto const& s) { return s.waves(); }, shape_);
    }
    [[nodiscard]] double amplitude() const
    {
        return factor_ * std::visit([](auto const& s) { return s.amplitude(); }, shape_);
    }
    [[nodiscard]] bool even() const
    {
        return std::visit([](auto const& s) { return s.even(); }, shape_);
    }
    [[nodiscard]] std::span<double const> breaks() const
    {
        return std::visit([](auto const& s) { return std::span<double const>(s.breaks()); }, shape_);
    }
    [[nodiscard]] RadialDisplacement operator()(double u) const
    {
        if (auto const* cosine = std::get_if<CosineCam>(&shape_))
            return times_factor((*cosine)(u));
        return std::visit([this, u](auto const& s) { return times_factor(s(u)); }, shape_);
    }

    /// The shape as a cosine cam, where it is one.
    [[nodiscard]] std::optional<CosineCam> as_cosine() const
    {
        auto const* cosine = std::get_if<CosineCam>(&shape_);
        if (cosine == nullptr)
            return std::nullopt;
        return CosineCam{cosine->w0 * factor_, cosine->n};
    }

    /// The same shape with every displacement multiplied by @p factor > 0: what a slice of a coned cup has.
    [[nodiscard]] AnyWaveShape scaled(double factor) const
    {
        AnyWaveShape result = *this;
        result.factor_ *= factor;
        return result;
    }

  private:
    [[nodiscard]] RadialDisplacement times_factor(RadialDisplacement d) const
    {
        d.w *= factor_;
        d.w1 *= factor_;
        d.w2 *= factor_;
        d.w3 *= factor_;
        return d;
    }

    Families shape_;
    double factor_ = 1;
};

/// Every registered wave generator family, in the order of registration.
/// `waves` and `family` are keys of [wave_generator] itself, not of a family.
[[nodiscard]] std::vector<scene::FamilyDescription> const& wave_generator_families();

/// Builds the shape of @p choice for the ring of @p place; adds to @p faults what is wrong with it.
[[nodiscard]] AnyWaveShape build_wave_shape(scene::FamilyChoice const& choice, WaveGeneratorPlace const& place,
                                            Faults& faults);

}  // namespace hdconj::wavegen
