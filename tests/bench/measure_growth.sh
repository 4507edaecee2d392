#!/usr/bin/env bash
# Three rounds through a rendered storey: what a keyframe costs, and what is in memory. See usage() below.
set -euo pipefail

usage() {
  cat <<'TEXT'
usage: tests/bench/measure_growth.sh BIN OUT [OTHER]
  BIN              folder of wardslam, rawlog-synth and libprocessor_clock.so
  OUT              folder for the recording, the runs, and growth.svg; a recording that is there is used again
  OTHER            folder of another build's wardslam, to be drawn pale beside it

630 m at 7.5 Hz; masks given. In one thread, and times are those of the processor, so that it may have other things to do.
TEXT
}

(($# >= 2)) || { usage >&2; exit 2; }
here=$(realpath "$(dirname "${BASH_SOURCE[0]}")")
bin=$(realpath "$1") out=$2 other=''
if (($# > 2)); then other=$(realpath "$3"); fi
readonly round_s=250.5
mkdir -p "$out"
cd "$out"

[[ -f three.rawlog ]] || "$bin/rawlog-synth" -o three.rawlog --scene hospital --route wards --seconds 752 --people few \
  --rate 7.5 --width 320 --height 240

go() { # go NAME FOLDER
  LD_PRELOAD=$bin/libprocessor_clock.so "$2/wardslam" run three.rawlog --masks three_labels/masks --deterministic \
    --out "$1" >"$1.log" 2>&1
}

runs=()
if [[ -n $other ]]; then
  go before "$other"
  runs+=(before=before/load.csv)
fi
go now "$bin"
python3 "$here/plot_growth.py" growth.svg "$round_s" "${runs[@]}" now=now/load.csv
"$bin/wardslam" eval three.groundtruth.txt now/trajectory.txt | grep -iE 'ATE|coverage'
