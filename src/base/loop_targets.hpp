// SPDX-License-Identifier: GPL-3.0-or-later
// HDCONJ_TARGETS before a function: it is compiled for several generations of processors, and the best one is chosen
// when the program is loaded.
#pragma once

// A choice at load time needs a resolver that runs before a sanitizer is awake.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__) && !defined(HDCONJ_ONE_TARGET)
#define HDCONJ_TARGETS __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define HDCONJ_TARGETS
#endif
