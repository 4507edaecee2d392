# shellcheck shell=bash
# Sourced by what measures days in a rendered hospital. The caller has a usage() and sets rate.

# read_arguments BIN OUT [OPTION]...: sets bin, out, route, rate, seed, and goes to OUT.
read_arguments() {
  (($# >= 2)) || { usage >&2; exit 2; }
  bin=$(realpath "$1") out=$2 route=lobby seed=1
  shift 2
  while (($# > 0)); do
    case "$1" in
      --route) route=$2; shift 2 ;;
      --rate) rate=$2; shift 2 ;;
      --seed) seed=$2; shift 2 ;;
      *) usage >&2; exit 2 ;;
    esac
  done
  mkdir -p "$out"
  cd "$out" || exit
}

# render NAME DAY ROBOT [OPTION]...: a recording, where it is not there.
render() {
  [[ -f $1.rawlog ]] || "$bin/rawlog-synth" -o "$1.rawlog" --scene hospital --route "$route" --seed "$seed" \
    --day "$2" --robot "$3" --rate "$rate" --width 320 --height 240 "${@:4}"
}
