// SPDX-License-Identifier: GPL-3.0-or-later
// The solved tooth of the circular spline as points, for [circular_spline.profile].
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "base/text.hpp"
#include "drive/drive.hpp"
#include "hdconj/error.hpp"
#include "hdconj/file/atomic_file.hpp"
#include "hdconj/result_files.hpp"

namespace hdconj {
namespace {

/// First and last point of the longest flank piece on the right side of the space. One piece is smooth; a spline
/// through points of several rings where their curvatures differ.
std::pair<std::size_t, std::size_t> right_wall_of(CircularSplineOutline const& spline)
{
    std::vector<Vec2> const& outline = spline.outline.front();
    std::pair<std::size_t, std::size_t> best{0, 0};
    double longest = 0;
    for (OutlinePiece const& piece : spline.pieces) {
        bool const right = outline[piece.first].x() + outline[piece.last].x() > 0;
        double const length = (outline[piece.last] - outline[piece.first]).norm();
        if (right && piece.kind == "flank" && length > longest) {
            best = {piece.first, piece.last};
            longest = length;
        }
    }
    return best;
}

}  // namespace

void write_spline_tooth(Solution const& solution, std::filesystem::path const& file)
{
    auto const [first, last] = right_wall_of(solution.circular_spline);
    constexpr std::size_t fewest = 4;  // of the family "points"
    if (last < first + fewest)
        throw FileError(file, "no flank of the tooth space touches: there are no points to write");
    Pose const frame = drive::spline_tooth_frame(solution.scene, solution.geometry);
    std::string rows;
    std::vector<Vec2> const& outline = solution.circular_spline.outline.front();
    for (std::size_t i = last + 1; i-- > first;) {
        Vec2 const p = frame.inverse(outline[i]);
        fmt::format_to(std::back_inserter(rows), "{:.15f},{:.15f}\n", p.x(), p.y());
    }
    double const tip = frame.origin.norm() - frame.inverse(outline[last]).y();
    auto const [lowest, highest] = std::ranges::minmax(outline, {}, [](Vec2 const& p) { return p.norm(); });
    file::write_text_atomically(
        file, fmt::format("# right flank of the circular spline's tooth of {}, from tip to root, y from the pitch line "
                          "towards the axis\n"
                          "# the longest smooth piece: the solved tooth goes on for {:.4f} mm of height at the tip and "
                          "for {:.4f} mm at the root\n"
                          "# write circular_spline.inner_radius = {:.15g} with it\nx,y\n",
                          printable(solution.scene.drive.name), outline[last].norm() - lowest.norm(),
                          highest.norm() - outline[first].norm(), tip) +
                  rows);
}

}  // namespace hdconj
