#!/usr/bin/env bash
# From a fresh Debian 12 or 13 to a running WardSLAM. Every verb can be run again at any time and from any folder.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")"
readonly PRESET=release
readonly BIN=build/${PRESET}/bin
readonly DEMO=demo

# What docs/architecture.md calls the libraries the project stands on, then the tools of the tests: by the same names
# in Debian 12 and 13.
readonly PACKAGES=(
  build-essential cmake ninja-build pkg-config
  libmrpt-dev libopencv-dev libceres-dev libeigen3-dev libyaml-cpp-dev libcli11-dev nlohmann-json3-dev libpcl-dev
  libsqlitecpp-dev libzstd-dev liboctomap-dev # the map file and its exports
  zlib1g-dev # rawlogs
  libpng-dev # masks
  libpqxx-dev # the hospital's database
  libbz2-dev liblz4-dev # recordings of ROS
  libcurl4-openssl-dev libssl-dev # wardslam models and fleet
  libembree-dev # rawlog-synth casts rays
  libegl1 libegl-mesa0 libgl1-mesa-dri # pictures of a map without a display
  libjs-dygraphs # plots of wardslam report
  libopenni2-dev # the virtual camera of the tests
  postgresql postgresql-postgis # a server of the tests' own
  mrpt-apps # rawlog-edit and rawlog-grabber, which the tests run
  dpkg-dev file # the Debian package
  libgtest-dev libgmock-dev libbenchmark-dev clang-format clang-tidy python3
)
# What is installed where the release has it; all is built, and nearly all tested, without.
readonly PACKAGES_WHERE_KNOWN=(
  libonnxruntime-dev # networks on ONNX Runtime; from Debian 13 on
  clang libclang-rt-dev # the verb fuzz
)

say() { printf '\n==> %s\n' "$*"; }

die() {
  printf 'bootstrap.sh: %s\n' "$*" >&2
  exit 1
}

usage() {
  cat <<'TEXT'
usage: ./bootstrap.sh VERB
  deps    install the Debian packages that are missing
  build   deps, then compile everything into build/release/
  demo    build, then map a synthetic ward with and without the filter; results in demo/
  test    build, then run all tests
  deb     build, then make the Debian package build/release/wardslam_*.deb
  fuzz    have libFuzzer try every parser, for 20 s each or so many as are given behind the verb; no part of the tests
  tidy    build, then clang-tidy over the whole tree (takes several minutes)
TEXT
}

# missing_among PACKAGE...: those that are not installed.
missing_among() {
  local package
  for package in "$@"; do
    [[ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" == installed ]] || printf '%s\n' "$package"
  done
}

# Those of PACKAGES_WHERE_KNOWN that are not installed, but could be.
missing_where_known() {
  local package
  for package in $(missing_among "${PACKAGES_WHERE_KNOWN[@]}"); do
    apt-cache show --no-all-versions "$package" &>/dev/null && printf '%s\n' "$package"
  done
  return 0
}

deps() {
  if ! { command -v apt-get && command -v dpkg-query; } >/dev/null; then
    die "this system has no apt; install the counterparts of these Debian packages yourself, then build with" \
      "cmake --preset ${PRESET}: ${PACKAGES[*]}"
  fi
  local missing as_root=()
  mapfile -t missing < <(missing_among "${PACKAGES[@]}"; missing_where_known)
  if ((${#missing[@]} == 0)); then
    say "All ${#PACKAGES[@]} Debian packages are there"
    return
  fi
  if ((EUID != 0)); then
    if ! command -v sudo >/dev/null; then
      [[ -z "$(missing_among "${PACKAGES[@]}")" ]] && return # all that is needed is there
      die "installing packages needs root and there is no sudo; as root run: apt-get install ${missing[*]}"
    fi
    as_root=(sudo)
  fi
  "${as_root[@]}" apt-get update ||
    die "apt-get update failed; check the network and /etc/apt/sources.list, then run this again"
  mapfile -t missing < <(missing_among "${PACKAGES[@]}"; missing_where_known) # apt may know more by now
  say "Installing ${#missing[@]} Debian packages: ${missing[*]}"
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install --yes --no-install-recommends "${missing[@]}" ||
    die "apt-get could not install what is missing (see its message above); WardSLAM needs: ${missing[*]}"
}

build() {
  deps
  say "Configuring (cmake --preset ${PRESET})"
  cmake --preset "$PRESET"
  say "Building into build/${PRESET}/ on $(nproc) cores"
  cmake --build --preset "$PRESET" --parallel "$(nproc)"
}

run_tests() {
  build
  say "Running all tests"
  ctest --preset "$PRESET" --parallel "$(nproc)"
}

deb() {
  build
  say "Making the Debian package"
  cpack --config "build/${PRESET}/CPackConfig.cmake" -B "build/${PRESET}"
}

tidy() {
  build
  say "Running clang-tidy over the whole tree"
  tests/style/tidy.sh "build/${PRESET}"
}

fuzz() { # fuzz [SECONDS]
  deps
  echo 'extern "C" int LLVMFuzzerTestOneInput(const unsigned char*, unsigned long) { return 0; }' |
    clang++ -x c++ -fsanitize=fuzzer,address - -o /dev/null ||
    die "this clang has no libFuzzer; install clang and its compiler-rt (Debian 12: libclang-rt-14-dev)"
  say "Building the fuzz targets into build/fuzz/"
  cmake --preset fuzz
  cmake --build --preset fuzz --parallel "$(nproc)"
  say "Running them for ${1:-20} s each"
  tests/fuzz/run "${1:-20}"
}

# json_number FILE KEY: the number that stands at the first "KEY".
json_number() { grep -m1 -oP "\"$2\":\s*\K[-+.eE0-9]+" "$1"; }

run_ward() { # run_ward on|off [more options]
  local filter=$1
  shift
  say "Tracking with the filter ${filter} (results in ${DEMO}/${filter}/)"
  "$BIN/wardslam" run "$DEMO/ward.rawlog" --filter "$filter" --out "$DEMO/$filter" --deterministic "$@"
  "$BIN/wardslam" eval "$DEMO/ward.groundtruth.txt" "$DEMO/$filter/trajectory.txt" --json >"$DEMO/$filter/evaluation.json"
}

demo_table() {
  local filter
  printf '\n%-8s %16s %12s %22s\n' filter 'ATE rmse [m]' coverage 'key points removed [%]'
  for filter in off on; do
    printf '%-8s %16.4f %12.3f %22.1f\n' "$filter" \
      "$(json_number "$DEMO/$filter/evaluation.json" rmse)" \
      "$(json_number "$DEMO/$filter/summary.json" coverage)" \
      "$(json_number "$DEMO/$filter/summary.json" dynamic_keypoint_fraction | awk '{print 100 * $1}')"
  done
}

demo() {
  build
  mkdir -p "$DEMO"
  say "Rendering ten seconds of a ward with walking people (${DEMO}/ward.rawlog)"
  "$BIN/rawlog-synth" -o "$DEMO/ward.rawlog" --seconds 10 --seed 1
  run_ward off
  run_ward on --pictures
  say "Error against the true trajectory"
  demo_table
  cat <<TEXT

Trajectories:  $PWD/$DEMO/{off,on}/trajectory.txt   truth: $PWD/$DEMO/ward.groundtruth.txt
Pictures:      $PWD/$DEMO/on/pictures/   what the filter removed, frame by frame
Figures:       $PWD/$DEMO/{off,on}/{summary,evaluation}.json
TEXT
}

case "${1-}" in
  deps | build | demo | deb | tidy) (($# == 1)) || { usage >&2; exit 2; }; "$1" ;;
  test) run_tests ;;
  fuzz) (($# <= 2)) || { usage >&2; exit 2; }; fuzz "${2-}" ;;
  -h | --help | help) usage ;;
  *) usage >&2; exit 2 ;;
esac
