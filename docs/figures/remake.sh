#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Remakes the parameter figures of the tooth families and their gallery: docs/figures/remake.sh build/release/bin/hdconj
set -e
program=$(realpath "$1")
cd "$(dirname "$0")/../.."
${PYTHON:-python3} docs/figures/tooth_families.py "$program" docs/figures
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
for scene in straight involute cycloid s-tooth s-tooth-deviated arc-chain bezier b-spline points; do
  "$program" solve "data/scenes/$scene.toml" -o "$scratch/result.h5" --picture "docs/gallery/$scene.svg" --quiet
done
