#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds hdconj if need be and runs it:  ./run.sh check my-drive.toml
# Without arguments it solves the built-in scene. Only the program writes to standard output.
set -eu
root=$(CDPATH= cd -- "$(dirname -- "$0")" && pwd)
. "$root/cmake/bootstrap.sh"

need_packages build
# Tests, once configured by test.sh, stay configured; a first build goes without them.
if [ -f "$build/CMakeCache.txt" ]; then configure; else configure -DHDCONJ_BUILD_TESTS=OFF; fi
build_targets hdconj

[ $# -gt 0 ] || set -- solve
exec "$build/bin/hdconj" "$@"
