// SPDX-License-Identifier: GPL-3.0-or-later
// Branches: maximal continuous pieces of {f = 0} on which the motion's parameter grows.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace hdconj::envelope {

/// Why a branch ends.
enum class BranchEnd
{
    segment_end,  ///< the contact leaves the segment
    double_root,  ///< two contacts merge: f = df/dt = 0
    cusp,         ///< the envelope reverses (undercut limit)
    range_end,    ///< end of the lobe (-pi/n, pi/n]
    continues     ///< only inside a branch: the next arc takes over
};

[[nodiscard]] inline std::string to_string(BranchEnd end)
{
    constexpr std::array<char const*, 5> words{"segment end", "double root", "cusp", "range end", "continues"};
    return words[static_cast<std::size_t>(end)];
}

/// One contact followed over an interval of the motion's parameter, on one piece of the profile.
struct ContactArc
{
    int piece = 0;
    /// arcs and corners: sign of the normal; curves: which root in increasing t; lines: 0
    int candidate = 0;
    int roots = 1;  ///< curves: number of roots on the open interval
    double u_begin = 0;
    double u_end = 0;
    double t_begin = 0;  ///< local piece parameter, exact at segment ends
    double t_end = 0;
    BranchEnd begins = BranchEnd::segment_end;
    BranchEnd ends = BranchEnd::segment_end;
    bool resting =
        false;  ///< arcs: the centre stands still to roundoff while the contact runs along, so t is taken linear in u
    bool bounding = false;          ///< locally a boundary of the swept region (outer envelope)
    std::vector<double> reversals;  ///< where t(u) turns back: ends of conjugate zones
};

/// Consecutive contact arcs on one segment, u increasing.
struct Branch
{
    int segment = 0;
    bool corner = false;
    std::vector<ContactArc> arcs;
};

/// A place where the number of roots is not known: within `width` of u a branch may exist that was not found.
///
/// Its contacts lie where |f| <= F, and f is the speed of the tooth along its own normal. So the tooth covers at most
/// reach = F width more than the known branches say, measured along the normal.
struct RootDoubt
{
    int piece = -1;  ///< of the profile; -1: all
    double t = 0;    ///< local piece parameter
    double u = 0;
    double width = 0;  ///< of the interval about u [rad]
    double reach = 0;  ///< how far such a branch can stand out of the known ones [mm]
    std::string what;
};

/// What tracing did besides finding branches.
struct TraceRecord
{
    std::size_t evaluations = 0;
    std::size_t roots = 0;
    std::vector<RootDoubt> doubts;  ///< in the order of the profile

    /// Every interval was decided: no root is missing, none invented.
    [[nodiscard]] bool certified() const { return doubts.empty(); }
};

}  // namespace hdconj::envelope
