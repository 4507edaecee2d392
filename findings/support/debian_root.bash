# shellcheck shell=bash
# Sourced by findings, which set PACKAGE, VERSION and SUITE (what they are about, and the Debian it is of) and may set
# TOOLS (other packages they need).

die() {
  printf '%s\n' "$*" >&2
  exit 1
}

make_root() { # make_root DIR
  debootstrap --variant=minbase "$SUITE" "$1" >&2
  chroot "$1" env DEBIAN_FRONTEND=noninteractive \
    apt-get install --yes --no-install-recommends "$PACKAGE" "${TOOLS[@]+"${TOOLS[@]}"}" >&2
}

in_root() { chroot "$root" env --chdir="/${work#"$root"/}" "$@" 2>&1; }

# enter_root [--root DIR]: sets `root`, a folder `work` in it, and says what is installed there. Both go at the end, a root
# that was given stays.
enter_root() {
  local version
  ((EUID == 0)) || die "needs root, for chroot"
  root='' made=''
  if [[ ${1-} == --root ]]; then
    root=$(realpath "$2")
  else
    (($# == 0)) || die "usage: $0 [--root DIR]"
    made=$(mktemp -d)
    trap 'rm -rf --one-file-system "$made"' EXIT
    root=$made
    make_root "$root"
  fi
  work=$(mktemp -d -p "$root/tmp")
  trap 'rm -rf --one-file-system "$work" ${made:+"$made"}' EXIT
  # shellcheck disable=SC2016 # dpkg-query's, not the shell's
  version=$(chroot "$root" dpkg-query -W -f '${Version}' "$PACKAGE") || die "$root has no $PACKAGE"
  printf '%s %s\n' "$PACKAGE" "$version"
  # shellcheck disable=SC2153 # it is set by the finding
  [[ $version == "$VERSION"* ]] || die "this is about version $VERSION: look again"
}

# build_program: build/look, from C++ on standard input that uses mrpt-maps.
build_program() {
  cat >"$work/look.cpp"
  cat >"$work/CMakeLists.txt" <<'CMAKE'
cmake_minimum_required(VERSION 3.25)
project(look LANGUAGES C CXX)
find_package(mrpt-maps REQUIRED)
add_executable(look look.cpp)
target_link_libraries(look PRIVATE mrpt::maps)
CMAKE
  in_root cmake -S . -B build >"$work/log" || die "$(cat "$work/log")"
  in_root cmake --build build >"$work/log" || die "$(cat "$work/log")"
}
