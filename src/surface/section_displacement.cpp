// SPDX-License-Identifier: GPL-3.0-or-later
#include "section_displacement.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>

#include "hdconj/base/parallel.hpp"
#include "hdconj/numeric/fourier.hpp"

namespace hdconj::surface {

SectionDisplacement::SectionDisplacement(double low, double high, DisplacementOf const& displacement_of, int nodes,
                                         int threads)
{
    for (int j = 0; j < nodes; ++j) {
        double const x = std::cos(std::numbers::pi * (j + 0.5) / nodes);
        height_.push_back(0.5 * (low + high) + 0.5 * (high - low) * x);
    }
    slice_.resize(height_.size());
    constexpr std::size_t grain = 4;
    parallel_for(height_.size(), threads, grain, [&](std::size_t j) { slice_[j] = displacement_of(height_[j]); });
}

SectionDisplacement::Line SectionDisplacement::line(double phi) const
{
    std::vector<wavegen::PointDisplacement> at;
    at.reserve(slice_.size());
    for (wavegen::MaterialDisplacement const& slice : slice_)
        at.push_back(wavegen::displacement_at(slice, phi));
    return {height_, std::move(at)};
}

wavegen::PointDisplacement SectionDisplacement::Line::operator()(double height) const
{
    std::vector<double> const& node = *height_;
    wavegen::PointDisplacement sum;
    for (std::size_t j = 0; j < node.size(); ++j) {
        double weight = 1;
        for (std::size_t i = 0; i < node.size(); ++i)
            if (i != j)
                weight *= (height - node[i]) / (node[j] - node[i]);
        sum.w[0] += weight * at_[j].w[0];
        sum.v[0] += weight * at_[j].v[0];
    }
    return sum;
}

wavegen::PointDisplacement SectionDisplacement::operator()(double phi, double height) const
{
    return line(phi)(height);
}

std::optional<wavegen::MaterialDisplacement> SectionDisplacement::along(HeightOf const& height_of) const
{
    int const waves = slice_.front().waves;
    double const period = 2 * std::numbers::pi / waves;
    // both series are sampled at the same angles
    std::map<double, wavegen::PointDisplacement> known;
    auto const at = [&](double phi) -> wavegen::PointDisplacement const& {
        auto const [place, fresh] = known.try_emplace(phi);
        if (fresh)
            place->second = (*this)(phi, height_of(phi));
        return place->second;
    };
    numeric::FourierSeries const w([&](double phi) { return at(phi).w[0]; }, period);
    numeric::FourierSeries const v([&](double phi) { return at(phi).v[0]; }, period);
    if (!w.resolved() || !v.resolved())
        return std::nullopt;
    // of both together: one of them may be all rounding
    double const noise = std::max(w.noise(), v.noise());
    auto const above_noise = [&](double coefficient) { return std::abs(coefficient) > noise ? coefficient : 0.0; };
    bool const symmetric = std::all_of(slice_.begin(), slice_.end(), [](wavegen::MaterialDisplacement const& slice) {
        return wavegen::is_symmetric(slice);
    });
    wavegen::MaterialDisplacement result{waves, {}};
    for (std::size_t k = 0; k < std::max(w.terms(), v.terms()); ++k) {
        wavegen::DisplacementHarmonic h{above_noise(w.cosine(k)), above_noise(w.sine(k)), above_noise(v.cosine(k)),
                                        above_noise(v.sine(k))};
        if (symmetric)
            h.w_sine = h.v_cosine = 0;
        result.harmonics.push_back(h);
    }
    wavegen::drop_empty_tail(result);
    return result;
}

}  // namespace hdconj::surface
