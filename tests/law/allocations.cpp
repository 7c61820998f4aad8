// SPDX-License-Identifier: GPL-3.0-or-later
// What is not asked for is not even allocated: counted by replacing the global operator new of this program.
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

#include "hdconj/io/scene_toml.hpp"
#include "hdconj/pipeline/solve.hpp"
#include "support/catch.hpp"

namespace {

std::atomic<std::size_t> allocations{0};

void* counted(std::size_t size)
{
    allocations.fetch_add(1, std::memory_order_relaxed);
    if (void* const memory = std::malloc(size == 0 ? 1 : size))
        return memory;
    throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size)
{
    return counted(size);
}

void* operator new[](std::size_t size)
{
    return counted(size);
}

void operator delete(void* memory) noexcept
{
    std::free(memory);
}

void operator delete[](void* memory) noexcept
{
    std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept
{
    std::free(memory);
}

void operator delete[](void* memory, std::size_t) noexcept
{
    std::free(memory);
}

namespace {

using namespace hdconj;

/// Allocations of one solve on one thread, after a first one that fills what is made once.
std::size_t allocations_of(Scene const& scene)
{
    (void)solve(scene);
    std::size_t const before = allocations;
    (void)solve(scene);
    return allocations - before;
}

}  // namespace

TEST_CASE("effects that solve has no use for cost it no allocation", "[effects]")
{
    Scene base = builtin_scene();
    base.solver.threads = 1;
    std::size_t const plain = allocations_of(base);
    REQUIRE(plain > 100);
    CHECK(allocations_of(base) == plain);
    // asked of the verb contact, not of solve
    Scene contact = base;
    contact.contact.emplace();
    CHECK(allocations_of(contact) == plain);
    // an effect whose stage runs allocates: the count can tell
    Scene slices = base;
    slices.slices = Slices{3, "tilted", 0};
    CHECK(allocations_of(slices) > plain);
}
