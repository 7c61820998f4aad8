# SPDX-License-Identifier: GPL-3.0-or-later
# Shared by run.sh and test.sh, which set `root`. All talk goes to standard error: standard output is the program's.
preset=${HDCONJ_PRESET:-release}
build=$root/build/$preset

# ccache fails where it cannot write; without a usable home its store goes beside the build.
[ -w "${HOME:-/nowhere}" ] || export CCACHE_DIR="${CCACHE_DIR:-$root/build/.ccache}"

say() { printf '%s\n' "$*" >&2; }

# packages SECTION...: the names in these sections of debian-packages.txt
packages() {
  for section in "$@"; do
    sed -n "/^\[$section\]/,/^\[/{/^[[#]/d;p}" "$root/cmake/debian-packages.txt"
  done
}

# clang_version: of the clang that this release installs; empty where apt knows none (yet)
clang_version() { apt-cache depends clang 2>/dev/null | sed -n 's/.*Depends: clang-\([0-9]*\)$/\1/p' | head -1; }

# is_known PACKAGE: apt can install it
is_known() { apt-cache policy "$1" 2>/dev/null | grep -q 'Candidate: [^(]'; }

# missing_packages SECTION...: the names that are to be installed; of those with a ? only what apt knows
missing_packages() {
  present=$(dpkg-query -W -f '${db:Status-Abbrev}${Package}\n' | sed -n 's/^ii *//p')
  packages "$@" | while read -r name; do
    case $name in *CLANG*) name=${name%%CLANG*}$(clang_version)${name##*CLANG} ;; esac
    if printf '%s\n' "${name%\?}" | grep -qxF "$present"; then continue; fi
    case $name in *\?) is_known "${name%\?}" || continue ;; esac
    printf '%s ' "${name%\?}"
  done
}

# need_packages SECTION...: installs what is missing; returns at once when nothing is.
# On a system without dpkg nothing is checked: CMake will say what it cannot find.
need_packages() {
  installed_something=no
  command -v dpkg-query >/dev/null || return 0
  missing=$(missing_packages "$@")
  [ -n "$missing" ] || return 0

  as_root=
  if [ "$(id -u)" != 0 ]; then
    if command -v sudo >/dev/null && { [ -t 0 ] || sudo -n true 2>/dev/null; }; then
      as_root=sudo
    else
      say "These packages are missing and may not be installed by this user; ask for"
      say "  apt-get install $missing"
      exit 1
    fi
  fi
  say "Installing $missing"
  {
    $as_root apt-get update && missing=$(missing_packages "$@") &&  # apt may know more now
    $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends $missing
  } >&2 || { say "Installing failed; the packages needed are: $missing"; exit 1; }
  installed_something=yes
}

# configure OPTION...: once; again when packages have come or an option is not yet set that way
configure() {
  again=$installed_something
  for option in "$@"; do
    name=${option#-D}
    grep -q "^${name%%=*}:[A-Z]*=${name#*=}\$" "$build/CMakeCache.txt" 2>/dev/null || again=yes
  done
  [ -f "$build/build.ninja" ] || [ -f "$build/Makefile" ] || again=yes
  [ "$again" = yes ] || return 0
  say "Configuring build/$preset"
  if command -v ninja >/dev/null; then
    cmake -S "$root" --preset "$preset" "$@" >&2
  else
    cmake -S "$root" --preset "$preset" -G "Unix Makefiles" "$@" >&2
  fi
}

# build_targets TARGET...: silent when everything is up to date
build_targets() {
  # The pipe would hide the build's status; fd 3 carries it round.
  status=$( { { { cmake --build "$build" --parallel "${HDCONJ_JOBS:-$(nproc)}" --target "$@" 2>&1; echo $? >&3; } |
      grep -v '^ninja: no work to do' >&2; } 3>&1; } || true)
  [ "$status" = 0 ] || { say "The build in build/$preset failed"; exit 1; }
}
