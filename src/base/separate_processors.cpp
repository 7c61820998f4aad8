// SPDX-License-Identifier: GPL-3.0-or-later
#include "separate_processors.hpp"

#ifdef __linux__
#include <sched.h>
#endif

namespace hdconj {

bool SeparateProcessors::take(int processor) noexcept
{
    auto const bit = static_cast<std::size_t>(processor);
    if (processor < 0 || bit / word_bits >= taken_.size())
        return true;
    std::uint64_t const mask = std::uint64_t{1} << (bit % word_bits);
    return (taken_[bit / word_bits].fetch_or(mask) & mask) == 0;
}

#ifdef __linux__

SeparateProcessors::SeparateProcessors() noexcept
{
    take(sched_getcpu());
}

void SeparateProcessors::settle() noexcept
{
    cpu_set_t allowed;
    int const here = sched_getcpu();
    if (take(here) || sched_getaffinity(0, sizeof allowed, &allowed) != 0)
        return;
    // from here on: programs side by side begin at different ones
    for (int i = 1; i < CPU_SETSIZE; ++i) {
        int const processor = (here + i) % CPU_SETSIZE;
        if (!CPU_ISSET(processor, &allowed) || !take(processor))
            continue;
        cpu_set_t there;
        CPU_ZERO(&there);
        CPU_SET(processor, &there);
        // where the first call is refused the second changes nothing
        (void)sched_setaffinity(0, sizeof there, &there);
        (void)sched_setaffinity(0, sizeof allowed, &allowed);
        return;
    }
}

#else

SeparateProcessors::SeparateProcessors() noexcept = default;
void SeparateProcessors::settle() noexcept {}

#endif

}  // namespace hdconj
