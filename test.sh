#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds everything and runs the tests; arguments go to ctest:  ./test.sh -L law
# HDCONJ_PRESET=asan-ubsan ./test.sh   the same under another configure preset
# HDCONJ_TARGETS=parallel_tests HDCONJ_PRESET=tsan ./test.sh -L parallel   builds only what these tests need
# HDCONJ_OPTIONS="-D..." adds options of CMake to those
set -eu
root=$(CDPATH= cd -- "$(dirname -- "$0")" && pwd)
. "$root/cmake/bootstrap.sh"

need_packages build test
if [ -n "${HDCONJ_TARGETS:-}" ]; then configure -DHDCONJ_BUILD_TESTS=ON ${HDCONJ_OPTIONS:-}; else
  configure -DHDCONJ_BUILD_TESTS=ON -DHDCONJ_BUILD_PYTHON=ON
fi
build_targets ${HDCONJ_TARGETS:-all}

# One more than there are cores: tests of pages and of ended runs mostly wait.
exec ctest --test-dir "$build" --output-on-failure --no-tests=error --parallel "${HDCONJ_JOBS:-$(($(nproc) + 1))}" "$@"
