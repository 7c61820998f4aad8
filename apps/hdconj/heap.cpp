// SPDX-License-Identifier: GPL-3.0-or-later
#include "heap.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace hdconj::cli {

void prepare_heap()
{
#if defined(__GLIBC__) && defined(MADV_HUGEPAGE)
    // addresses only: a page is memory once it is written to
    constexpr int ahead = 1 << 26;
    constexpr std::uintptr_t large_page = std::uintptr_t{1} << 21;
    // one heap for all threads: what they ask for in their loops is few and large, and small pieces come from stores of their own
    bool const told = mallopt(M_MMAP_THRESHOLD, ahead / 2) != 0 && mallopt(M_TRIM_THRESHOLD, 2 * ahead) != 0 && mallopt(M_TOP_PAD, ahead) != 0 &&
                      mallopt(M_ARENA_MAX, 1) != 0;
    if (!told) {
        return;
    }
    constexpr std::size_t more_than_there_is = std::size_t{1} << 20;
    void* const taken = std::malloc(more_than_there_is);
    auto const first = (reinterpret_cast<std::uintptr_t>(taken) + large_page - 1) / large_page * large_page;
    auto const end = reinterpret_cast<std::uintptr_t>(sbrk(0)) / large_page * large_page;
    std::free(taken);
    if (taken != nullptr && end > first) {
        (void)madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE);  // advice: refusal is an answer
    }
#endif
}

}  // namespace hdconj::cli
