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
        weight_.push_back((j % 2 == 0 ? 1 : -1) * std::sin(std::numbers::pi * (j + 0.5) / nodes));
    }
    slice_.resize(height_.size());
    constexpr std::size_t grain = 4;
    parallel_for(height_.size(), threads, grain, [&](std::size_t j) { slice_[j] = displacement_of(height_[j]); });
}

SectionDisplacement::Line SectionDisplacement::line(double phi) const
{
    // cosine and sine of the multiples follow by adding angles, as in displacement_at()
    std::size_t terms = 0;
    for (wavegen::MaterialDisplacement const& slice : slice_)
        terms = std::max(terms, slice.harmonics.size());
    double const angle = slice_.front().waves * phi, cosine = std::cos(angle), sine = std::sin(angle);
    std::vector<double> c(terms, 1), s(terms, 0);
    for (std::size_t k = 1; k < terms; ++k) {
        c[k] = c[k - 1] * cosine - s[k - 1] * sine;
        s[k] = s[k - 1] * cosine + c[k - 1] * sine;
    }
    std::vector<WallPoint> nodes;
    nodes.reserve(slice_.size());
    for (wavegen::MaterialDisplacement const& slice : slice_) {
        WallPoint at;
        for (std::size_t k = 0; k < slice.harmonics.size(); ++k) {
            wavegen::DisplacementHarmonic const& h = slice.harmonics[k];
            at.w += h.w_cosine * c[k] + h.w_sine * s[k];
            at.v += h.v_cosine * c[k] + h.v_sine * s[k];
        }
        nodes.push_back(at);
    }
    return {*this, std::move(nodes)};
}

WallPoint SectionDisplacement::Line::operator()(double height) const
{
    WallPoint sum;
    double weights = 0;
    for (std::size_t j = 0; j < at_.size(); ++j) {
        double const off = height - of_->height_[j];
        if (off == 0)
            return at_[j];
        double const weight = of_->weight_[j] / off;
        weights += weight;
        sum.w += weight * at_[j].w;
        sum.v += weight * at_[j].v;
    }
    return {sum.w / weights, sum.v / weights};
}

WallPoint SectionDisplacement::operator()(double phi, double height) const
{
    return line(phi)(height);
}

std::optional<wavegen::MaterialDisplacement> SectionDisplacement::along(HeightOf const& height_of) const
{
    int const waves = slice_.front().waves;
    double const period = 2 * std::numbers::pi / waves;
    // both series are sampled at the same angles
    std::map<double, WallPoint> known;
    auto const at = [&](double phi) -> WallPoint const& {
        auto const [place, fresh] = known.try_emplace(phi);
        if (fresh)
            place->second = (*this)(phi, height_of(phi));
        return place->second;
    };
    numeric::FourierSeries const w([&](double phi) { return at(phi).w; }, period);
    numeric::FourierSeries const v([&](double phi) { return at(phi).v; }, period);
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
