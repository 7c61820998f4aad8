// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "file/dxf_groups.hpp"
#include "hdconj/file/atomic_file.hpp"
#include "hdconj/result_files.hpp"

namespace hdconj {
namespace {

constexpr file::dxf::Layer circular_spline = {"CIRCULAR_SPLINE", file::dxf::white};
constexpr file::dxf::Layer flexspline_tooth = {"FLEXSPLINE_TOOTH", file::dxf::red};
constexpr file::dxf::Layer neutral_curve = {"NEUTRAL_CURVE", file::dxf::blue};

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
    file::dxf::Groups out;
    file::dxf::begin(out, layers);
    auto const& slices = solution.circular_spline;
    for (std::size_t k = 0; k < slices.outline.size(); ++k)
        file::dxf::write_polyline(out, circular_spline, 0, slices.outline[k], Vec2::Zero(), slices.z.at(k));
    file::dxf::write_polyline(out, flexspline_tooth, 0, solution.flexspline_outline, major_axis(solution.geometry),
                              middle);
    file::dxf::write_polyline(out, neutral_curve, file::dxf::closed, solution.neutral_curve, Vec2::Zero(), middle);
    file::dxf::end(out);
    file::write_text_atomically(file, out.text());
}

}  // namespace hdconj
