// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A data race on purpose: the thread sanitizer must see it, or its silence about the solver means nothing.
#include <cstdio>

int main()
{
    int sum = 0;
#pragma omp parallel for num_threads(4)
    for (int i = 0; i < 100000; ++i)
        sum += i;
    std::printf("%d\n", sum);
    return 0;
}
