#!/usr/bin/env bash
# Two days in a rendered hospital, three runs on each, every run on the map of the one before. See usage() below.
set -euo pipefail

usage() {
  cat <<'TEXT'
usage: tests/bench/measure_days.sh BIN OUT [OPTION]...
  BIN              folder of wardslam and rawlog-synth
  OUT              folder for recordings, runs and tables; recordings that are there are used again
  --route ROUTE    lobby (25 m, unless told), round (140 m), wards, corridor or tour
  --rate HZ        pictures a second (10)
  --seed N         another hospital (1)

Runs as by default, in threads. Every run begins elsewhere and drives in another order (--robot). In the second run of
each day a hand covers the lens for four seconds; the third run of the first day is killed half way and made again. After
every run: file checked, poses, objects and free floor against the truth, and whether things kept their records.
TEXT
}

# shellcheck source=tests/bench/hospital_days.sh
source "$(dirname "${BASH_SOURCE[0]}")/hospital_days.sh"
rate=10
read_arguments "$@"
readonly map=ward.wardmap

go() { # go NAME: run on the map of the one before, if there is one
  local arguments=("$1.rawlog" --masks "$1_labels/masks" --out "$1")
  if [[ -f $map ]]; then arguments+=(--map "$map"); fi
  "$bin/wardslam" run "${arguments[@]}" >"$1.log" 2>&1
}

go_and_kill() { # go_and_kill NAME: killed when half of the pictures have a pose
  local pictures run
  pictures=$(grep -vc '^#' "$1.groundtruth.txt")
  go "$1" &
  run=$!
  while kill -0 "$run" 2>/dev/null; do
    if (($(cat "$1"/trajectory_live.txt* 2>/dev/null | wc -l) > pictures / 2)); then break; fi
    sleep 0.2
  done
  pkill -KILL -f "wardslam run $1.rawlog" || true
  wait "$run" 2>/dev/null || true
}

records() { # records NAME: identity of a true thing, id of its record
  "$bin/wardslam" eval-objects "$1_labels/objects.csv" "$1/objects.json" --trajectory "$1/trajectory.txt" \
    --ground-truth "$1.groundtruth.txt" --objects >"$1.objects"
  awk -F, 'NR == FNR { identity[$2] = $15; next }
    / = / { split($0, part, " = "); name = part[1]; sub(/^ *true +/, "", name); sub(/,.*/, "", part[2]);
            print identity[name], part[2] }' "$1_labels/objects.csv" <(grep -E '^ *true .* = ' "$1.objects") |
    sort -n >"$1.records"
}

identities() { # identities NAME BEFORE: what became of the records
  awk -v day="$3" -F'[ ,]' '
    FILENAME == ARGV[1] { if ($1 == day) change[$2] = $5; next }
    FILENAME == ARGV[2] { before[$1] = $2; was[$2] = $1; next }
    { now[$1] = $2 }
    END {
      for (thing in now) {
        if (thing in before) {
          if (now[thing] == before[thing]) same++; else if (change[thing] == "") lost++; else renamed++
        }
        if ((now[thing] in was) && was[now[thing]] != thing) {
          if (change[thing] == "swapped") unseen++; else mistaken++
        }
      }
      printf "records: %d kept, %d of things nobody moved are new, %d of things moved are new, %d of another thing (and %d of things that changed places with their like)\n", same, lost, renamed, mistaken, unseen
    }' "$1_labels/days.csv" "$2.records" "$1.records"
}

judge() { # judge NAME BEFORE DAY
  printf '\n== %s\n' "$1"
  "$bin/wardslam" map check "$map" | head -n 3
  "$bin/wardslam" eval "$1.groundtruth.txt" "$1/trajectory.txt" | grep -iE 'ATE|coverage' || true
  records "$1"
  grep -E '^(class|all)' "$1.objects"
  "$bin/wardslam" eval-floor "$1_labels/floor.yaml" "$map" --trajectory "$1/trajectory.txt" \
    --ground-truth "$1.groundtruth.txt"
  if [[ -n $2 ]]; then identities "$1" "$2" "$3"; fi
}

finish() { # finish NAME: the first run's map is the one to go on in
  if [[ ! -f $map ]]; then cp "$1/map.wardmap" "$map"; fi
}

before=''
for day in 0 1; do
  for robot in 0 1 2; do
    name=day${day}_robot$robot
    options=()
    if ((robot == 1)); then options=(--cover 8:4); fi
    render "$name" "$day" "$robot" "${options[@]}"
    if ((day == 0 && robot == 2)); then
      go_and_kill "$name"
      printf '\n== %s killed\n' "$name"
      "$bin/wardslam" map check "$map" | head -n 3
    fi
    status=0
    go "$name" || status=$?
    if ((status != 0)); then printf '%s ends with %d: %s\n' "$name" "$status" "$(tail -n 2 "$name.log")"; fi
    finish "$name"
    judge "$name" "$before" "$day"
    before=$name
  done
done
