// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// How the program's threads wait for each other.
///
/// Between two loops GNU's OpenMP spins, by its own choice for some five milliseconds. That uses up the time slices of
/// a thread that will be wanted in a moment: beside other work on the machine two threads then take two to three times
/// as long as one. A tenth of a millisecond is enough to be there for the next loop; a thread that sleeps is woken at
/// once. What the user says by OMP_WAIT_POLICY or GOMP_SPINCOUNT holds.
#include <cstdlib>

#if defined(__GNUC__) && !defined(__clang__)

namespace {

/// OpenMP reads the environment in its own constructor, which has no priority and so comes later (it is linked from its
/// archive, cmake/Dependencies.cmake).
constexpr int before_the_libraries = 101;

[[gnu::constructor(before_the_libraries)]] void wait_briefly()
{
    if (std::getenv("OMP_WAIT_POLICY") == nullptr) {
        (void)setenv("GOMP_SPINCOUNT", "3000",
                     0);  // without it the program is as right, and as quick on a machine at rest
    }
}

}  // namespace

#endif
