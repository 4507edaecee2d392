#!/usr/bin/env bash
# The hospital's database: ten robots that push while its server is killed, and how it does with a hundred. See usage().
set -euo pipefail

usage() {
  cat <<'TEXT'
usage: tests/bench/measure_fleet.sh BIN OUT [OPTION]...
  BIN          folder of wardslam and measure_fleet
  OUT          folder for the server's data and the maps; must not be there
  --maps N     how many maps each of ten robots pushes while the server is killed (100); 0 leaves that out
  --no-scale   leaves out what fills and asks a database of 100 robots, 100,000 things, 1,000,000 sightings

Starts a PostgreSQL server of its own, with the settings Debian gives it, on a socket in OUT, and ends it. Each robot pushes
two states of each map, again until it hears that they are there; meanwhile all processes of the server get SIGKILL, again
and again. Then each map's rows are counted and compared with those of a map that was pushed in peace, and a file of each
robot is pulled and compared with the one pushed.
TEXT
}

(($# >= 2)) || { usage >&2; exit 2; }
bin=$(realpath "$1") out=$(realpath -m "$2")
maps=100 scale=yes
shift 2
while (($# > 0)); do
  case "$1" in
    --maps) maps=$2; shift 2 ;;
    --no-scale) scale=no; shift ;;
    *) usage >&2; exit 2 ;;
  esac
done
readonly bin out maps scale
[[ ! -e $out ]] || { echo "$out is there already" >&2; exit 2; }

postgres=$(printf '%s\n' /usr/lib/postgresql/*/bin | sort -V | tail -n 1)
as_user=()
mkdir -p "$out/server"
if ((EUID == 0)); then # the server refuses to run as root
  as_user=(setpriv --reuid=postgres --regid=postgres --clear-groups)
  chown postgres "$out/server"
fi
control() { (cd / && "${as_user[@]}" "$postgres/pg_ctl" -D "$out/server/data" "$@" >/dev/null 2>&1); }
start() { control start -w -t 120 -l "$out/server/log" -o "-c listen_addresses='' -k '$out/server'"; }
(cd / && "${as_user[@]}" "$postgres/initdb" --auth=trust --username=postgres --encoding=UTF8 --locale=C \
  -D "$out/server/data" >/dev/null)
start
trap 'control stop -m immediate || true' EXIT
database() { printf 'postgresql:///%s?host=%s&user=postgres' "$1" "$out/server"; }
sql() { "$postgres/psql" -X -q -A -t -v ON_ERROR_STOP=1 "$(database "$1")" -c "SET search_path = wardslam, public" -c "$2"; }
make_database() {
  "$postgres/psql" -X -q "$(database postgres)" -c "CREATE DATABASE $1"
  "$bin/wardslam" fleet init --database "$(database "$1")"
}

kill_server() { # stopped first, so that it has no more children
  local server children
  server=$(head -n 1 "$out/server/data/postmaster.pid")
  kill -STOP "$server"
  until ps -o stat= -p "$server" | grep -q '^T'; do sleep 0.01; done
  children=$(ps -o pid= --ppid "$server" || true)
  # shellcheck disable=SC2086  # several numbers
  kill -KILL "$server" $children 2>/dev/null || true
  while ps -o stat= -p "$server" | grep -qv Z; do sleep 0.01; done
  rm -f "$out/server/data/postmaster.pid" "$out/server/.s.PGSQL.5432.lock"
}

count_rows() { # per map: robot, map and how many rows of each kind
  sql kills "SELECT r.name, m.name, (SELECT count(*) FROM keyframes WHERE map = m.id),
    (SELECT count(*) FROM objects WHERE map = m.id), (SELECT count(*) FROM sightings WHERE map = m.id),
    (SELECT count(*) FROM zones WHERE map = m.id), (SELECT count(*) FROM rooms WHERE map = m.id),
    (SELECT count(*) FROM runs WHERE map = m.id), (SELECT count(*) FROM file_chunks WHERE map = m.id),
    (SELECT count(*) FROM pushes WHERE map = m.id), (SELECT count(*) FROM changes WHERE map = m.id)
    FROM maps m JOIN robots r ON r.id = m.robot ORDER BY r.name = 'peace' DESC, 1, 2"
}

measure_kills() {
  local kills=0 pusher begun robot
  make_database kills
  mkfifo "$out/told"
  "$bin/measure_fleet" push "$(database kills)" "$out" "$maps" >"$out/told" &
  pusher=$!
  {
    read -r begun && [[ $begun == begun ]]
    RANDOM=1
    while kill -0 "$pusher" 2>/dev/null; do
      sleep "$((RANDOM % 5)).$((RANDOM % 10))"
      kill_server
      kills=$((kills + 1))
      start
    done
    cat
  } <"$out/told"
  wait "$pusher"
  echo "kills: $kills"
  count_rows | awk -F'|' -v wanted=$((10 * maps + 1)) '
    NR == 1 { for (i = 3; i <= NF; ++i) peace[i] = $i }
    { ++maps; for (i = 3; i <= NF; ++i) { rows += $i; if ($i < peace[i]) lost += peace[i] - $i; else doubled += $i - peace[i] } }
    END { printf "maps: %d of %d, rows: %d, lost: %d, doubled: %d\n", maps, wanted, rows, lost, doubled }'
  for robot in {0..9}; do
    "$bin/wardslam" fleet pull -o "$out/pulled.wardmap" --robot "robot $robot" --database "$(database kills)" >/dev/null
    cmp "$out/pulled.wardmap" "$out/after.wardmap"
  done
  echo "pulled files are those pushed"
}

measure_scale() {
  make_database scale
  "$bin/measure_fleet" scale "$(database scale)" "$out"
  sql scale "SELECT 'rows: ' || (SELECT count(*) FROM sightings) || ' sightings, ' || (SELECT count(*) FROM objects) ||
    ' things, ' || (SELECT count(*) FROM keyframes) || ' keyframes; ' ||
    pg_size_pretty(pg_database_size('scale')) || ' in all'"
  sql scale "SELECT relname, pg_size_pretty(pg_total_relation_size(oid)), pg_size_pretty(pg_indexes_size(oid))
    FROM pg_class WHERE relnamespace = 'wardslam'::regnamespace AND relkind = 'r'
    ORDER BY pg_total_relation_size(oid) DESC LIMIT 5"
}

if ((maps > 0)); then measure_kills; fi
if [[ $scale == yes ]]; then measure_scale; fi
