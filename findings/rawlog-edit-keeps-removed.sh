#!/usr/bin/env bash
# rawlog-edit of MRPT 2.14.7 (Debian 13) says that it removed entries, ends with 0, and writes a rawlog that holds them.
#
# Who takes a camera out of a recording before handing it on still has it in there. The input is made by MRPT's own
# carmen2rawlog from a log of five laser scans and five odometry readings. With MRPT 2.5.8 (Debian 12) the three
# operations do what they say.
#
# usage: rawlog-edit-keeps-removed.sh [--root DIR]   (as root; DIR: a Debian 13 with mrpt-apps in it. Without it, such a
#        root is made with debootstrap in a temporary folder, some 2 GB, and removed at the end.)
# Ends with 0 while the fault is there, with 1 where anything is different.
set -euo pipefail

readonly PACKAGE=mrpt-apps VERSION='1:2.14.7+ds-1' SUITE=trixie

# shellcheck source=findings/support/debian_root.bash
source "$(dirname "${BASH_SOURCE[0]}")/support/debian_root.bash"

carmen_log() {
  local i
  for i in 0 1 2 3 4; do
    echo "ODOM 0.$i 0 0 0.1 0 0 100$i.0 robot 100$i.0"
    echo "FLASER 5 1.0 1.1 1.2 1.1 1.0 0.$i 0 0 0.$i 0 0 100$i.5 robot 100$i.5"
  done
}

# entries FILE: what rawlog-edit counts, "10 objects, FLASER 5, ODOMETRY 5".
entries() {
  in_root rawlog-edit -i "$1" --info | awk '
    /Overall number of objects/ { line = $NF " objects" }
    /^Sensor / { line = line ", " $4 " " $6 }
    END { print line }'
}

# check RIGHT FAULTY OPTIONS...: prints what rawlog-edit says and what is in its output; RIGHT should be, FAULTY is.
check() {
  local right=$1 faulty=$2 said left status=0
  shift 2
  said=$(in_root rawlog-edit -i walk.rawlog -o edited.rawlog "$@") || status=$?
  said=$(grep -o 'Removed entries.*' <<<"$said" | tr -s ' ') || said='nothing of removed entries'
  left=$(entries edited.rawlog)
  rm -f "$work/edited.rawlog"
  printf '%s\n  ends with %d, says "%s"\n  should be: %s\n  is:        %s\n' \
    "rawlog-edit -i walk.rawlog -o edited.rawlog $*" "$status" "$said" "$right" "$left"
  [[ $status == 0 && $said == 'Removed entries : '[1-9]* && $left == "$faulty" ]] || changed=1
}

enter_root "$@"

carmen_log >"$work/walk.log"
in_root carmen2rawlog -i walk.log -o walk.rawlog >/dev/null || die "carmen2rawlog could not make the input"
all=$(entries walk.rawlog)
printf 'input: %s\n' "$all"
[[ $all == '10 objects, FLASER 5, ODOMETRY 5' ]] || die "the input is not what it should be"

changed=0
check '5 objects, ODOMETRY 5' "$all" --remove-label FLASER
check '5 objects, ODOMETRY 5' "$all" --keep-label ODOMETRY
# It stops reading one behind the end of the span, which is why not all ten are there.
check '4 objects, FLASER 2, ODOMETRY 2' '7 objects, FLASER 3, ODOMETRY 4' --cut --from-index 2 --to-index 5
((changed == 0)) || die "that is not the fault described here any more"
echo 'The fault is there: all that was "removed" is still in the output.'
