// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/axial/section_displacement.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "hdconj/numeric/fourier.hpp"

namespace hdconj {

SectionDisplacement::SectionDisplacement(double low, double high, DisplacementOf const& displacement_of, int nodes)
{
    for (int j = 0; j < nodes; ++j)
    {
        double const x = std::cos(std::numbers::pi * (j + 0.5) / nodes);
        height_.push_back(0.5 * (low + high) + 0.5 * (high - low) * x);
        slice_.push_back(displacement_of(height_.back()));
    }
}

PointDisplacement SectionDisplacement::operator()(double phi, double height) const
{
    PointDisplacement sum;
    for (std::size_t j = 0; j < height_.size(); ++j)
    {
        double weight = 1;
        for (std::size_t i = 0; i < height_.size(); ++i)
            if (i != j)
                weight *= (height - height_[i]) / (height_[j] - height_[i]);
        PointDisplacement const at = displacement_at(slice_[j], phi);
        sum.w[0] += weight * at.w[0];
        sum.v[0] += weight * at.v[0];
    }
    return sum;
}

std::optional<MaterialDisplacement> SectionDisplacement::along(HeightOf const& height_of) const
{
    int const waves = slice_.front().waves;
    double const period = 2 * std::numbers::pi / waves;
    FourierSeries const w([&](double phi) { return (*this)(phi, height_of(phi)).w[0]; }, period);
    FourierSeries const v([&](double phi) { return (*this)(phi, height_of(phi)).v[0]; }, period);
    if (!w.resolved() || !v.resolved())
        return std::nullopt;
    // of both together: one of them may be all rounding
    double const noise = std::max(w.noise(), v.noise());
    auto const above_noise = [&](double coefficient) { return std::abs(coefficient) > noise ? coefficient : 0.0; };
    bool const symmetric = std::all_of(slice_.begin(), slice_.end(), [](MaterialDisplacement const& slice) { return is_symmetric(slice); });
    MaterialDisplacement result{waves, {}};
    for (std::size_t k = 0; k < std::max(w.terms(), v.terms()); ++k)
    {
        DisplacementHarmonic h{above_noise(w.cosine(k)), above_noise(w.sine(k)), above_noise(v.cosine(k)), above_noise(v.sine(k))};
        if (symmetric)
            h.w_sine = h.v_cosine = 0;
        result.harmonics.push_back(h);
    }
    drop_empty_tail(result);
    return result;
}

}  // namespace hdconj
