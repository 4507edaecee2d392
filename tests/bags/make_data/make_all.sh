#!/usr/bin/env bash
# Makes ../data again. Wanted: python3 with Pillow and, from Debian 12, python3-rosbag, python3-sensor-msgs,
# python3-nav-msgs, python3-tf2-msgs, python3-geometry-msgs, python3-std-msgs (in PYTHONPATH); zstd; node with
# npm install @mcap/core @foxglove/rosmsg @foxglove/rosmsg2-serialization @foxglove/wasm-zstd lz4js in the folder WORK.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
work=${1:?usage: make_all.sh WORK}
data=$here/../data
mkdir -p "$data" "$work/scene"
python3 "$here/prepare.py" --scene "$work/scene" 3
cp "$here/mcap.mjs" "$work/"
python3 "$here/ros1_bag.py" "$work/scene" "$data/none.bag" none --robot --chunk 20000
python3 "$here/ros1_bag.py" "$work/scene" "$data/bz2.bag" bz2 --chunk 20000
python3 "$here/ros1_bag.py" "$work/scene" "$data/lz4.bag" lz4 --chunk 20000
python3 "$here/ros1_bag.py" "$work/scene" "$data/compressed.bag" none --compressed
python3 "$here/ros1_bag.py" "$work/scene" "$data/unclosed.bag" lz4 --unclosed --chunk 20000
mcap() { node "$work/mcap.mjs" "$work/scene" "$@"; }
mcap "$data/none.mcap" none --chunk 20000 --robot --dump "$work/messages.json"
mcap "$data/zstd.mcap" zstd --chunk 20000
mcap "$data/lz4.mcap" lz4 --chunk 20000
mcap "$data/no_index.mcap" zstd --chunk 20000 --no-index
mcap "$data/unchunked.mcap" unchunked
mcap "$data/float.mcap" zstd --float
python3 "$here/rosbag2_sqlite.py" "$work/messages.json" "$data/sqlite" --split 9
python3 "$here/rosbag2_zstd.py" "$data/sqlite" "$data/sqlite_zstd"
python3 "$here/realsense_bag.py" "$work/scene" "$data/realsense.bag"
python3 "$here/realsense_db3.py" "$work/scene" "$data/realsense.db3"
ls -l "$data" "$data/sqlite"
