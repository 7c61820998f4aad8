// SPDX-License-Identifier: GPL-3.0-or-later
// What is not asked for is not even allocated: counted by replacing the global operator new of this program.
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

#include "hdconj/contact.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/scene/reading.hpp"
#include "hdconj/solve.hpp"
#include "support/catch.hpp"

namespace {

std::atomic<std::size_t> allocations{0};

void* counted(std::size_t size) noexcept
{
    allocations.fetch_add(1, std::memory_order_relaxed);
    return std::malloc(size == 0 ? 1 : size);
}

void* required(void* memory)
{
    return memory != nullptr ? memory : throw std::bad_alloc();
}

/// Not inline: the compiler would see memory of operator new freed by free().
[[gnu::noinline]] void freed(void* memory) noexcept
{
    std::free(memory);
}

}  // namespace

void* operator new(std::size_t size)
{
    return required(counted(size));
}

void* operator new[](std::size_t size)
{
    return required(counted(size));
}

void* operator new(std::size_t size, std::nothrow_t const&) noexcept
{
    return counted(size);
}

void* operator new[](std::size_t size, std::nothrow_t const&) noexcept
{
    return counted(size);
}

void operator delete(void* memory) noexcept
{
    freed(memory);
}

void operator delete[](void* memory) noexcept
{
    freed(memory);
}

void operator delete(void* memory, std::size_t) noexcept
{
    freed(memory);
}

void operator delete[](void* memory, std::size_t) noexcept
{
    freed(memory);
}

namespace {

using namespace hdconj;

/// Allocations of one call, after a first one that fills what is made once.
template <class Call>
std::size_t allocations_in(Call const& call)
{
    (void)call();
    std::size_t const before = allocations;
    (void)call();
    return allocations - before;
}

/// Of the check of all values, also those that a verb has no use for.
std::size_t allocations_of_check(Scene const& scene)
{
    return allocations_in([&] { return scene::value_faults(scene); });
}

/// Of one solve, without the words of its plan and that check.
std::size_t allocations_of(Scene const& scene)
{
    return allocations_in([&] { return solve(scene); }) - allocations_in([&] { return make_plan(scene); }) -
           allocations_of_check(scene);
}

/// Of one contact study, without that check.
std::size_t allocations_of_contact(Scene const& scene)
{
    return allocations_in([&] { return study_contact(scene); }) - allocations_of_check(scene);
}

/// One effect that a verb makes nothing of.
struct Effect
{
    char const* name;
    void (*add)(Scene&);
};

void add_coning(Scene& scene)
{
    scene.coning.emplace();
    scene.coning->model = ConingModel::linear;
    scene.coning->axial_shift = AxialShift::none;
    scene.coning->bottom_to_middle = 9;
}

void add_cup(Scene& scene)
{
    Cup& cup = scene.flexspline.cup.emplace();
    cup.length = 15;
    cup.barrel_wall = 0.4;
    cup.bottom = 0.5;
    cup.corner_radius = 2;
    cup.flange_radius = 13;
    cup.tooth_width = 8;
    scene.bearing.emplace();
}

/// The wire that corners are judged with where the scene has none.
void add_wire(Scene& scene)
{
    scene.wedm.emplace();
    scene.wedm->wire_diameter = 0.1;
    scene.wedm->spark_gap = 0.006;
    scene.wedm->residual_limit = 0.01;
}

/// What contact has no use for, and solve neither.
std::vector<Effect> const of_other_verbs{
    {"load", [](Scene& s) { s.load.emplace(); }}, {"wedm", add_wire}, {"cup and bearing", add_cup}};

/// Each of @p effects, added to @p base, leaves the allocations of a run as they are.
void check_free(Scene const& base, std::vector<Effect> const& effects, std::size_t (*allocations_of_run)(Scene const&))
{
    std::size_t const plain = allocations_of_run(base);
    for (Effect const& effect : effects) {
        INFO(effect.name);
        Scene with = base;
        effect.add(with);
        CHECK(allocations_of_run(with) == plain);
    }
}

}  // namespace

TEST_CASE("effects that solve has no use for cost it no allocation", "[effects]")
{
    Scene base = builtin_scene();
    base.solver.threads = 1;
    std::size_t const plain = allocations_of(base);
    REQUIRE(plain > 100);
    CHECK(allocations_of(base) == plain);
    check_free(base, of_other_verbs, allocations_of);
    // asked of another verb, or without slices that they could act on
    check_free(base,
               {{"contact", [](Scene& s) { s.contact.emplace(); }},
                {"coning", add_coning},
                {"tilt",
                 [](Scene& s) {
                     s.tilt = Tilt{0.01, TiltKind::radial, 0};
                 }},
                {"backlash", [](Scene& s) { s.circular_spline.backlash_offset = 0; }}},
               allocations_of);
    // an effect whose stage runs allocates: the count can tell
    Scene slices = base;
    slices.slices = Slices{3, ToothSurface::tilted, 0};
    std::size_t const sliced = allocations_of(slices);
    CHECK(sliced > plain);
    Scene backlash = base;
    backlash.circular_spline.backlash_offset = 0.01;
    CHECK(allocations_of(backlash) != plain);
    // with slices: one outline for all of them makes nothing of a cone, slices of their own do
    Scene cone = slices;
    add_coning(cone);
    CHECK(allocations_of(cone) == sliced);
    cone.slices->surface = ToothSurface::per_slice;
    CHECK(allocations_of(cone) > sliced);
    // a tilt moves what is there, a draft makes outlines
    Scene draft = slices;
    draft.tilt = Tilt{0.003, TiltKind::draft, 0};
    CHECK(allocations_of(draft) > sliced);
}

TEST_CASE("effects that contact has no use for cost it no allocation", "[effects]")
{
    Scene base = builtin_scene();
    base.solver.threads = 1;
    base.contact = ContactRequest{1e-3, 30, 0, 0};
    std::size_t const plain = allocations_of_contact(base);
    REQUIRE(plain > allocations_of(base));
    check_free(base, of_other_verbs, allocations_of_contact);
    // what it has a use for
    Scene slices = base;
    slices.slices = Slices{3, ToothSurface::tilted, 0};
    std::size_t const sliced = allocations_of_contact(slices);
    CHECK(sliced > plain);
    Scene cone = slices;
    add_coning(cone);
    CHECK(allocations_of_contact(cone) > sliced);
    Scene tilt = slices;
    tilt.tilt = Tilt{0.003, TiltKind::radial, 0};
    CHECK(allocations_of_contact(tilt) > sliced);
    Scene automatic = base;
    automatic.circular_spline.automatic_backlash = true;
    CHECK(allocations_of_contact(automatic) == plain);
}
