// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "hdconj/result_files.hpp"
#include "hdf5_reader.hpp"
#include "io/layout/results.hpp"

namespace hdconj::io::hdf5 {
namespace {

std::vector<OutlinePiece> pieces_of(hid_t place, std::size_t points)
{
    constexpr std::size_t list = 1;
    auto const kinds = texts_of(place, "pieces/kind"), segments = texts_of(place, "pieces/segment_name");
    auto const first = values_of<int>(Opened(place, "pieces/first", list), H5T_NATIVE_INT);
    auto const last = values_of<int>(Opened(place, "pieces/last", list), H5T_NATIVE_INT);
    require(segments.size() == kinds.size() && first.size() == kinds.size() && last.size() == kinds.size(),
            "lists of pieces differ in length");
    std::vector<OutlinePiece> pieces;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        require(first[i] >= 0 && last[i] >= first[i] && static_cast<std::size_t>(last[i]) < points,
                "a piece lies outside the outline");
        pieces.push_back(
            {kinds[i], segments[i], static_cast<std::size_t>(first[i]), static_cast<std::size_t>(last[i])});
    }
    return pieces;
}

CircularSplineOutline outline_of(hid_t file)
{
    constexpr std::size_t list = 1, slices_points_coordinates = 3, plane = 2;
    Group const place(H5Gopen2(file, "circular_spline", H5P_DEFAULT), "open the circular spline");
    CircularSplineOutline result;
    result.z = values_of<double>(Opened(place, "z", list), H5T_NATIVE_DOUBLE);
    Opened const outline(place, "outline", slices_points_coordinates);
    auto const flat = values_of<double>(outline, H5T_NATIVE_DOUBLE);
    std::size_t const slices = static_cast<std::size_t>(outline.shape[0]),
                      points = static_cast<std::size_t>(outline.shape[1]);
    require(outline.shape[2] == plane && slices == result.z.size() && slices > 0 && points > 0,
            "outline and z do not go together");
    for (double const value : flat)
        require(std::isfinite(value), "a point of the outline is not finite");
    for (std::size_t k = 0; k < slices; ++k) {
        auto& slice = result.outline.emplace_back();
        for (std::size_t i = 0; i < points; ++i) {
            std::size_t const at = plane * (k * points + i);
            slice.emplace_back(flat[at], flat[at + 1]);
        }
    }
    result.landmarks = values_of<int>(Opened(place, "landmarks", list), H5T_NATIVE_INT);
    for (int const landmark : result.landmarks)
        require(landmark >= 0 && static_cast<std::size_t>(landmark) < points, "a landmark lies outside the outline");
    result.pieces = pieces_of(place, points);
    return result;
}

}  // namespace
}  // namespace hdconj::io::hdf5

namespace hdconj {

StoredOutline read_outline(std::filesystem::path const& file)
{
    using namespace io::hdf5;
    StoredKind const result{"no result file of hdconj", "make one: hdconj solve -o FILE.h5", nullptr};
    return read_stored(file, result, [](File const& opened) {
        require(text_of(opened, "format") == "hdconj", "it is of another program");
        require(number_of(opened, "format_version") <= io::layout::format_version, "it was written by a newer version");
        return StoredOutline{text_of(opened, "scene"), outline_of(opened)};
    });
}

}  // namespace hdconj
