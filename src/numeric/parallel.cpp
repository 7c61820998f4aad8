// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/numeric/parallel.hpp"

#include <algorithm>
#include <exception>
#include <vector>

#ifdef _OPENMP
#include <omp.h>
#endif

namespace hdconj {

int thread_count(int requested)
{
#ifdef _OPENMP
    return requested > 0 ? requested : std::max(1, omp_get_num_procs());
#else
    (void)requested;
    return 1;
#endif
}

namespace {

/// One contiguous share of the loop; stops at its first exception, which is then the lowest of the share.
struct Share
{
    std::size_t begin = 0;
    std::size_t end = 0;
    std::exception_ptr thrown;

    void run(std::function<void(std::size_t)> const& body) noexcept
    {
        try
        {
            for (std::size_t i = begin; i < end; ++i)
                body(i);
        }
        catch (...)
        {
            thrown = std::current_exception();
        }
    }
};

}  // namespace

void parallel_for(std::size_t count, int threads, std::size_t grain, std::function<void(std::size_t)> const& body)
{
    std::size_t const worth = std::max<std::size_t>(1, count / std::max<std::size_t>(1, grain));
    std::size_t const team = std::min(static_cast<std::size_t>(thread_count(threads)), worth);
    std::vector<Share> shares(team);
    for (std::size_t k = 0; k < team; ++k)
    {
        shares[k].begin = count * k / team;
        shares[k].end = count * (k + 1) / team;
    }
    if (team == 1)
    {
        shares[0].run(body);
    }
    else
    {
        auto const n = static_cast<int>(team);
#ifdef _OPENMP
#pragma omp parallel for num_threads(n) schedule(static, 1)
#endif
        for (int k = 0; k < n; ++k)
            shares[static_cast<std::size_t>(k)].run(body);
    }
    for (Share const& share : shares)
        if (share.thrown)
            std::rethrow_exception(share.thrown);
}

}  // namespace hdconj
