// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The motion that a scene asks for, owned; private to src/study.
#pragma once

#include <concepts>
#include <memory>
#include <span>
#include <utility>

#include "hdconj/motion/erased_motion.hpp"
#include "hdconj/motion/exact_motion.hpp"
#include "hdconj/motion/inverse_motion.hpp"
#include "hdconj/wavegen/registry.hpp"

namespace hdconj::accuracy {

using StudyExactMotion = motion::ExactMotion<wavegen::AnyWaveShape>;

/// A relative motion of any model behind one type, shared by its copies. Same values as the model's own, bit for bit.
class StudyMotion
{
  public:
    template <class Motion>
    requires(!std::same_as<Motion, StudyMotion> && motion::RelativeMotion<Motion>) explicit StudyMotion(Motion motion)
        : StudyMotion(std::make_shared<Motion const>(std::move(motion)))
    {
    }

    [[nodiscard]] Pose pose(double u) const { return motion_.pose(u); }
    [[nodiscard]] motion::MotionRates rates(double u) const { return motion_.rates(u); }
    [[nodiscard]] motion::ToothAngles angles(double u) const { return motion_.angles(u); }
    [[nodiscard]] double half_lobe() const { return motion_.half_lobe(); }
    [[nodiscard]] std::span<double const> breaks() const { return motion_.breaks(); }
    [[nodiscard]] bool symmetric() const { return motion_.symmetric(); }

    /// Circular-spline tooth @p number as the flexspline tooth of this motion sees it.
    [[nodiscard]] StudyMotion seen_from_flexspline(int number, double pitch, double radius) const
    {
        struct Seen
        {
            StudyMotion flexspline;
            motion::InverseMotion<StudyMotion> motion;

            Seen(StudyMotion of, Pose const& seat) : flexspline(std::move(of)), motion(flexspline, seat) {}
            Seen(Seen const&) = delete;  // `motion` refers to its neighbour
            Seen& operator=(Seen const&) = delete;
        };
        auto const seen = std::make_shared<Seen const>(*this, motion::circular_spline_seat(number, pitch, radius));
        return StudyMotion(std::shared_ptr<motion::InverseMotion<StudyMotion> const>(seen, &seen->motion));
    }

  private:
    template <class Motion>
    explicit StudyMotion(std::shared_ptr<Motion const> motion) : motion_(*motion), owner_(std::move(motion))
    {
    }

    motion::ErasedMotion motion_;
    std::shared_ptr<void const> owner_;
};

}  // namespace hdconj::accuracy
