// SPDX-License-Identifier: GPL-3.0-or-later
// Any motion model behind one type. All that stands above the envelope is compiled for this one alone.
#pragma once

#include <concepts>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "hdconj/motion/cosine_form.hpp"
#include "hdconj/motion/inverse_motion.hpp"
#include "hdconj/motion/relative_motion.hpp"

namespace hdconj::motion {

/// A relative motion of any model. Same values as the model's own, bit for bit.
class AnyMotion
{
  public:
    /// Refers to @p motion, which must outlive this and its copies.
    /// @param closed_form  cosine_form() of the motion, for those who compute many points: these differ from the points
    ///                     of pose() by some roundings
    template <RelativeMotion Motion>
    requires(!std::same_as<Motion, AnyMotion>) explicit AnyMotion(Motion const& motion,
                                                                  std::optional<CosineForm> const& closed_form = {})
        : object_(&motion), calls_(&calls_of<Motion>), closed_form_(closed_form)
    {
    }

    /// Owns @p motion together with its copies.
    template <RelativeMotion Motion>
    [[nodiscard]] static AnyMotion owning(Motion motion, std::optional<CosineForm> const& closed_form = {})
    {
        auto owner = std::make_shared<Motion const>(std::move(motion));
        AnyMotion result(*owner, closed_form);
        result.owner_ = std::move(owner);
        return result;
    }

    [[nodiscard]] Pose pose(double u) const { return calls_->pose(object_, u); }
    [[nodiscard]] MotionRates rates(double u) const { return calls_->rates(object_, u); }
    [[nodiscard]] MotionState state(double u) const { return calls_->state(object_, u); }
    [[nodiscard]] ToothAngles angles(double u) const { return calls_->angles(object_, u); }
    [[nodiscard]] std::optional<CosineForm> const& closed_form() const { return closed_form_; }
    [[nodiscard]] double half_lobe() const { return calls_->half_lobe(object_); }
    [[nodiscard]] std::span<double const> breaks() const { return calls_->breaks(object_); }
    [[nodiscard]] bool symmetric() const { return calls_->symmetric(object_); }

  private:
    struct Calls
    {
        Pose (*pose)(void const*, double);
        MotionRates (*rates)(void const*, double);
        MotionState (*state)(void const*, double);
        ToothAngles (*angles)(void const*, double);
        double (*half_lobe)(void const*);
        std::span<double const> (*breaks)(void const*);
        bool (*symmetric)(void const*);
    };

    template <class Motion>
    static Motion const& as(void const* object)
    {
        return *static_cast<Motion const*>(object);
    }

    template <class Motion>
    static constexpr Calls calls_of{[](void const* o, double u) { return as<Motion>(o).pose(u); },
                                    [](void const* o, double u) { return as<Motion>(o).rates(u); },
                                    [](void const* o, double u) { return state_of(as<Motion>(o), u); },
                                    [](void const* o, double u) { return as<Motion>(o).angles(u); },
                                    [](void const* o) -> double { return as<Motion>(o).half_lobe(); },
                                    [](void const* o) -> std::span<double const> { return as<Motion>(o).breaks(); },
                                    [](void const* o) -> bool { return as<Motion>(o).symmetric(); }};

    void const* object_;
    Calls const* calls_;
    std::optional<CosineForm> closed_form_;
    std::shared_ptr<void const> owner_;  ///< nothing where the motion is referred to
};

/// Circular-spline tooth @p k as the flexspline tooth of @p flexspline sees it. @param radius  of the seat [mm]
[[nodiscard]] inline AnyMotion seen_from_flexspline(AnyMotion const& flexspline, int k, double pitch, double radius)
{
    return AnyMotion::owning(InverseMotion<AnyMotion>(flexspline, circular_spline_seat(k, pitch, radius)));
}

}  // namespace hdconj::motion
