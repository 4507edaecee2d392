#!/usr/bin/env bash
# Three runs in a rendered hospital, on three days by three robots, each with a map of its own, made one. See usage().
set -euo pipefail

usage() {
  cat <<'TEXT'
usage: tests/bench/measure_merge.sh BIN OUT [OPTION]...
  BIN              folder of wardslam and rawlog-synth
  OUT              folder for recordings, runs and maps; recordings and runs that are there are used again
  --route ROUTE    lobby (25 m, unless told), round (140 m), wards, corridor or tour
  --rate HZ        pictures a second (5)
  --seed N         another hospital (1)

Errors of the keyframes of each run alone and of all in the frame of the merged map; things before and after, against what
truly stood there on the last day; whether the order of the maps matters; whether the same maps give the same bytes.
TEXT
}

# shellcheck source=tests/bench/hospital_days.sh
source "$(dirname "${BASH_SOURCE[0]}")/hospital_days.sh"
rate=5
read_arguments "$@"
readonly runs=(day0 day1 day2)

for day in 0 1 2; do
  name=day$day
  render "$name" $day $day
  [[ -f $name/map.wardmap ]] || "$bin/wardslam" run "$name.rawlog" --masks "${name}_labels/masks" --out "$name" \
    >"$name.log" 2>&1
  cp "$name/map.wardmap" "$name.wardmap"
done

time "$bin/wardslam" map merge day{0,1,2}.wardmap -o all.wardmap
"$bin/wardslam" map check all.wardmap
"$bin/wardslam" map merge day{2,0,1}.wardmap -o other_order.wardmap >/dev/null
"$bin/wardslam" map merge day{0,1,2}.wardmap -o again.wardmap >/dev/null
cmp all.wardmap again.wardmap && echo "the same maps give the same bytes"
cmp all.wardmap other_order.wardmap && echo "so they do in another order"

trajectory() { "$bin/wardslam" map export "$1.wardmap" --trajectory "$1.poses.txt" >/dev/null; }
error() { printf '%-28s' "$1"; "$bin/wardslam" eval "$2" "$3" | grep ATE; }
things() { # things WHAT MAP DAY TRUE_POSES
  "$bin/wardslam" map objects "$2.wardmap" --json >"$2.objects.json"
  printf '%-28s' "$1"
  "$bin/wardslam" eval-objects "${3}_labels/objects.csv" "$2.objects.json" --trajectory "$2.poses.txt" \
    --ground-truth "$4" | grep -E '^all'
}

sort -s -n -m <(grep -v '^#' day0.groundtruth.txt) <(grep -v '^#' day1.groundtruth.txt) \
  <(grep -v '^#' day2.groundtruth.txt) >true_poses.txt
trajectory all
printf '\nkeyframes                            rmse        mean      median         std         min         max   pairs\n'
for name in "${runs[@]}"; do
  trajectory "$name"
  error "$name alone" "$name.groundtruth.txt" "$name.poses.txt"
done
error "all in one frame" true_poses.txt all.poses.txt
printf '\nthings                              wanted  got  recall  found  true  precision\n'
for name in "${runs[@]}"; do things "$name alone, of that day" "$name" "$name" "$name.groundtruth.txt"; done
things "merged, of the last day" all day2 true_poses.txt
"$bin/wardslam" map objects all.wardmap --state any | awk '{ states[$NF]++ } END { for (s in states) if (s ~ /static|moved|gone/) print s, states[s] }'
