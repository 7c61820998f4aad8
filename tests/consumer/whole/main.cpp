// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// From the built-in scene to a solution, as another program would.
#include <cstdio>

#include "hdconj/read_scene.hpp"
#include "hdconj/solve.hpp"
#include "hdconj/version.hpp"

int main()
{
    hdconj::Scene const scene = hdconj::builtin_scene({"solver.tolerance=1e-4"});
    hdconj::Solution const solution = hdconj::solve(scene);

    std::size_t const points = solution.circular_spline.outline.at(0).size();
    std::printf("hdconj %s: %zu points\n", hdconj::program_version().data(), points);
    return points > 0 ? 0 : 1;
}
