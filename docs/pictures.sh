#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes the pictures of the docs, but for those of accuracy.md. `hdconj accuracy --page FOLDER/accuracy.md` draws these
# into FOLDER/figures, from ten minutes of measurements.
#   docs/pictures.sh BUILD_DIR         all, in two minutes
#   docs/pictures.sh BUILD_DIR quick   those that take a second each
# They go to docs/figures and docs/gallery; git keeps the few that pages show (.gitignore). Needs gnuplot; h5py for the
# figures of the families.
set -eu
program=$(realpath "$1")/bin/hdconj
quick=${2:-}
cd "$(dirname -- "$0")"
python=${PYTHON:-python3}
scenes=../data/scenes
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir -p figures gallery

run() { "$program" "$@" --quiet -o "$scratch/$1"; }
# keep NAME.svg AS.svg: one picture of several
keep() { mv "$scratch/$1" "figures/$2"; }

run solve --picture figures/type-50.svg
for scene in straight involute cycloid s-tooth s-tooth-deviated arc-chain bezier b-spline points ellipse four-roller \
             two-disc ring-on-cosine-cam cam-table circular-spline-given; do
  run solve "$scenes/$scene.toml" --picture "gallery/$scene.svg"
done
run solve "$scenes/type-50-wanted.toml" --picture figures/wanted/type-50.svg
run wedm "$scenes/type-50.toml" --tilt 0.2 --picture "$scratch/w.svg"
keep w-tooth.svg wedm-tooth.svg
(cd .. && "$program" inspect data/scenes/type-50.toml data/measured/flexspline-teeth.csv --probe 0.05 --quiet \
  --picture docs/figures/inspect/teeth.svg)
(cd .. && gnuplot docs/figures/rounding.gp && gnuplot docs/figures/tilt/loaded.gp && gnuplot docs/figures/load/members.gp)
"$python" figures/drive_section.py figures/drive-section.svg
if "$python" -c 'import h5py, tomllib' 2>/dev/null; then
  (cd .. && "$python" docs/figures/tooth_families.py "$program" docs/figures \
    && "$python" docs/figures/wave_generators.py "$program" docs/figures/wave-generators.svg \
    && "$python" docs/figures/tilt/sketch.py "$program" docs/figures/tilt-sketch.svg)
else
  echo "pictures: no h5py, the figures of tooth families, wave generators and tilt are left out" >&2
fi

if [ "$quick" != quick ]; then
  run wedm "$scenes/type-50.toml" --part flexspline --picture "$scratch/f.svg"
  keep f-tooth.svg wedm-flexspline-tooth.svg
  keep f-ring2.svg wedm-flexspline.svg
  coned="$scenes/type-50-coned.toml --set coning.axial_shift=none"
  run contact $scenes/type-50-coned.toml --surface tilted --kind radial,draft --set contact.contact_gap=0.02 \
    --picture "$scratch/c.svg" --tilt=-1,-0.8,-0.6,-0.4,-0.2,-0.1,0,0.025,0.05,0.075,0.1,0.125,0.15,0.2,0.3,0.4,0.6,0.8,1
  keep c-tilt.svg contact-tilt.svg
  run contact $coned --surface per-slice --set slices.count=33 --picture "$scratch/c.png"
  keep c-map.png contact-map.png
  keep c-flank.png contact-flank.png
  run contact $coned --surface tilted --tilt 0.2 --set slices.count=33 --picture "$scratch/t.png"
  keep t-map.png contact-map-tilted.png
  run load "$scenes/type-50-elastic.toml" --surface tilted,per-slice \
    --set circular_spline.backlash_offset=0.065 --picture "$scratch/l.svg"
  keep l-curve.svg load-curve.svg
  keep l-stiffness.svg load-stiffness.svg
  keep l-pressure.svg load-pressure.svg
  keep l-flank.svg load/flank.svg
  run load "$scenes/type-50-elastic.toml" --surface tilted --set circular_spline.backlash_offset=0.065 \
    --measured ../data/measured/torque-twist.csv --torque-constant 0.119 --counts-per-turn 2000 --picture "$scratch/m.svg"
  keep m-curve.svg measured-curve.svg
  run run "$scenes/type-50.toml" --set slices.count=9 --set slices.surface=per-slice \
    --set circular_spline.backlash_offset=0.04 --set errors.circular_spline.pitch_deviation=0.002 \
    --set friction.flanks=0.08 --set friction.bearing_load=0.0005 --set friction.bearing_speed=2 \
    --set friction.viscosity_40=100 --set friction.viscosity_100=11 --set friction.seal=0.01 \
    --set 'running.temperatures=[0, 40]' --set 'running.speeds=[500, 2000]' --picture "$scratch/r.svg"
  keep r-error.svg run/error.svg
  keep r-efficiency.svg run/efficiency.svg
fi
"$python" compact_svg.py figures/*.svg figures/inspect/*.svg figures/run/*.svg figures/load/*.svg gallery/*.svg
