// SPDX-License-Identifier: GPL-3.0-or-later
#include "study_bench.hpp"

#include <fmt/format.h>

#include <cstdlib>  // defines __GLIBC__ where that is the library
#include <fstream>
#include <sstream>

#include "hdconj/units.hpp"
#include "scene/tolerance_limits.hpp"

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace hdconj::accuracy {

void reset_peak_memory()
{
#if defined(__GLIBC__)
    (void)malloc_trim(0);  // what earlier runs have freed is not of this one
#endif
    std::ofstream("/proc/self/clear_refs") << "5";  // Linux: starts VmHWM anew
}

double peak_memory()
{
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);) {
        std::istringstream words(line);
        std::string key;
        double kilobytes = 0;
        if (words >> key >> kilobytes && key == "VmHWM:")
            return kilobytes / 1024;
    }
    return not_measured;
}

void take_surface(Scene& scene)
{
    if (!scene.slices)
        scene.slices = Slices{1, scene.tilt ? ToothSurface::tilted : ToothSurface::per_slice};
}

void note_surface(StudyRun const& bench, std::string const& study, Scene const& scene)
{
    bench.note(study, fmt::format("tooth surface \"{}\"{}", to_string(scene.slices->surface),
                                  scene.tilt ? fmt::format(", {} {:g} deg", to_string(scene.tilt->kind),
                                                           to_deg(scene.tilt->angle))
                                             : ""));
}

double power_of_ten(int digits)
{
    double power = 1;
    for (int i = 0; i < digits; ++i)
        power *= 10;
    return 1 / power;
}

std::vector<double> tolerances_of(Drive const& drive, int most)
{
    constexpr int coarsest = 3, finest = 15;
    std::vector<double> tolerances;
    for (int digits = coarsest; digits <= finest && static_cast<int>(tolerances.size()) < most; ++digits)
        if (double const tolerance = power_of_ten(digits);
            tolerance <= scene::tenth_of_module(drive) && tolerance >= scene::least_tolerance(drive))
            tolerances.push_back(tolerance);
    return tolerances;
}

}  // namespace hdconj::accuracy
