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

#if defined(__GLIBC__) && defined(MADV_HUGEPAGE)

namespace {

constexpr std::uintptr_t large_page = std::uintptr_t{1} << 21;

void advise_large_pages(std::uintptr_t first, std::uintptr_t end)
{
    first = (first + large_page - 1) / large_page * large_page;
    end = end / large_page * large_page;
    if (end > first)
        (void)madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE);  // advice: refusal is an answer
}

}  // namespace

void prepare_heap()
{
    // addresses only: a page is memory once it is written to
    constexpr int ahead = 1 << 26;
    bool const told = mallopt(M_MMAP_THRESHOLD, ahead / 2) != 0 && mallopt(M_TRIM_THRESHOLD, 2 * ahead) != 0 &&
                      mallopt(M_TOP_PAD, ahead) != 0;
    constexpr std::size_t more_than_there_is = std::size_t{1} << 20;
    void* const taken = told ? std::malloc(more_than_there_is) : nullptr;
    if (taken != nullptr)
        advise_large_pages(reinterpret_cast<std::uintptr_t>(taken), reinterpret_cast<std::uintptr_t>(sbrk(0)));
    std::free(taken);
}

void prepare_heap_of_thread() noexcept
{
    // the C library gives a thread a heap of its own, which begins at a multiple of its size; with M_TOP_PAD as above
    // it is laid out whole
    constexpr std::uintptr_t size = std::uintptr_t{1} << 26;
    constexpr std::size_t anything = 64;
    void* const taken = std::malloc(anything);
    if (taken != nullptr) {
        auto const at = reinterpret_cast<std::uintptr_t>(taken);
        advise_large_pages(at, (at / size + 1) * size);
    }
    std::free(taken);
}

#else

void prepare_heap() {}
void prepare_heap_of_thread() noexcept {}

#endif

}  // namespace hdconj::cli
