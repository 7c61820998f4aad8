// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Any motion model behind one type, where compiling once counts for more than a call through a pointer.
#pragma once

#include <span>

#include "hdconj/motion/relative_motion.hpp"

namespace hdconj::motion {

/// A relative motion of any model, referred to and not owned. Same values as the model's own, bit for bit.
class ErasedMotion
{
  public:
    template <RelativeMotion Motion>
    explicit ErasedMotion(Motion const& motion) : object_(&motion), calls_(&calls_of<Motion>)
    {
    }

    [[nodiscard]] Pose pose(double u) const { return calls_->pose(object_, u); }
    [[nodiscard]] MotionRates rates(double u) const { return calls_->rates(object_, u); }
    [[nodiscard]] ToothAngles angles(double u) const { return calls_->angles(object_, u); }
    [[nodiscard]] double half_lobe() const { return calls_->half_lobe(object_); }
    [[nodiscard]] std::span<double const> breaks() const { return calls_->breaks(object_); }
    [[nodiscard]] bool symmetric() const { return calls_->symmetric(object_); }

  private:
    struct Calls
    {
        Pose (*pose)(void const*, double);
        MotionRates (*rates)(void const*, double);
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
                                    [](void const* o, double u) { return as<Motion>(o).angles(u); },
                                    [](void const* o) -> double { return as<Motion>(o).half_lobe(); },
                                    [](void const* o) -> std::span<double const> { return as<Motion>(o).breaks(); },
                                    [](void const* o) -> bool { return as<Motion>(o).symmetric(); }};

    void const* object_;
    Calls const* calls_;
};

}  // namespace hdconj::motion
