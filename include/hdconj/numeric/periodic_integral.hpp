// SPDX-License-Identifier: GPL-3.0-or-later
// The integral of a periodic function, by Fourier series where it is smooth and panel by panel where it has breaks.
#pragma once

#include <optional>
#include <span>

#include "hdconj/numeric/fourier.hpp"
#include "hdconj/numeric/panel_integral.hpp"

namespace hdconj::numeric {

/// Integral from 0 of a periodic function.
/// Accuracy: relative_error() against its size; `resolved()` says whether the representation reached roundoff.
class PeriodicIntegral
{
  public:
    /// @param breaks  angles in (-period/2, period/2] at which f is not analytic, increasing; may be empty
    template <class F>
    PeriodicIntegral(F&& f, double period, std::span<double const> breaks)
    {
        if (breaks.empty())
            smooth_.emplace(f, period);
        else
            panels_.emplace(f, period, breaks);
    }

    [[nodiscard]] double mean() const { return smooth_ ? smooth_->mean() : panels_->mean(); }
    [[nodiscard]] bool resolved() const { return smooth_ ? smooth_->resolved() : panels_->resolved(); }
    [[nodiscard]] double relative_error() const
    {
        return smooth_ ? smooth_->relative_error() : panels_->relative_error();
    }

    /// The series, where there are no breaks.
    [[nodiscard]] FourierSeries const* series() const { return smooth_ ? &*smooth_ : nullptr; }

    /// Integral from 0 to @p u; @p sine and @p cosine of 2 pi u/period are used where there are no breaks.
    [[nodiscard]] double operator()(double u, double sine, double cosine) const
    {
        return smooth_ ? smooth_->integral(u, sine, cosine) : panels_->integral(u);
    }

  private:
    std::optional<FourierSeries> smooth_;
    std::optional<PanelIntegral> panels_;
};

}  // namespace hdconj::numeric
