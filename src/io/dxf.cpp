// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "dxf_groups.hpp"
#include "hdconj/io/atomic_file.hpp"
#include "hdconj/io/result_files.hpp"

namespace hdconj {
namespace {

constexpr dxf::Layer circular_spline = {"CIRCULAR_SPLINE", dxf::white};
constexpr dxf::Layer flexspline_tooth = {"FLEXSPLINE_TOOTH", dxf::red};
constexpr dxf::Layer neutral_curve = {"NEUTRAL_CURVE", dxf::blue};

/// The tooth where the wave generator is largest: its frame's origin at (0, r_0 + w0), its outline from the pitch line.
Vec2 major_axis(PairGeometry const& geometry)
{
    return {0, geometry.r_0 + geometry.w0 + geometry.pitch_line};
}

}  // namespace

void write_dxf(Solution const& solution, std::filesystem::path const& file)
{
    constexpr std::array layers = {circular_spline, flexspline_tooth, neutral_curve};
    constexpr double middle = 0;
    dxf::Groups out;
    dxf::begin(out, layers);
    auto const& slices = solution.circular_spline;
    for (std::size_t k = 0; k < slices.outline.size(); ++k) {
        dxf::write_polyline(out, circular_spline, 0, slices.outline[k], Vec2::Zero(), slices.z.at(k));
    }
    dxf::write_polyline(out, flexspline_tooth, 0, solution.flexspline_outline, major_axis(solution.geometry), middle);
    dxf::write_polyline(out, neutral_curve, dxf::closed, solution.neutral_curve, Vec2::Zero(), middle);
    dxf::end(out);
    write_text_atomically(file, out.text());
}

}  // namespace hdconj
