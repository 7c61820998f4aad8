#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Fuzzes each target for a number of seconds:  tests/fuzz/run.sh 60   or   tests/fuzz/run.sh 3600 scene_solve
# What was learnt stays in build/fuzz/corpus and is where the next run begins; finds are files in build/fuzz/finds, and
# make the exit status 1. A find is run again by   build/fuzz/bin/fuzz_<target> FILE   and belongs into
# tests/fuzz/finds.
set -eu
root=$(CDPATH= cd -- "$(dirname -- "$0")/../.." && pwd)
HDCONJ_PRESET=fuzz
. "$root/cmake/bootstrap.sh"

seconds=${1:?"seconds per target"}
shift
[ $# -gt 0 ] || set -- scene_text csv_profile design_wishes point_file scene_solve

need_packages build test
configure -DHDCONJ_BUILD_FUZZ=ON
build_targets $(printf 'fuzz_%s ' "$@")

# Sanitizers make everything about ten times slower: 100 s here are 10 s there, which the replay in the tests measures.
status=0
for target in "$@"; do
  learnt=$build/corpus/$target
  finds=$build/finds/$target
  log=$build/$target.log
  mkdir -p "$learnt" "$finds"
  say "== $target, $seconds s"
  "$build/bin/fuzz_$target" -max_total_time="$seconds" -timeout=100 -rss_limit_mb=4096 -max_len=4096 \
    -print_final_stats=1 -artifact_prefix="$finds/" "$learnt" "$root/tests/fuzz/corpus/$target" >"$log" 2>&1 || {
    status=1
    tail -n 60 "$log" >&2
    say "== $target: a find, in $finds"
  }
  grep -a -e '^#[0-9]*.DONE' -e '^stat::' "$log" >&2 || true
done
exit $status
