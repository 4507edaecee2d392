#!/usr/bin/env python3
"""A ROS 2 bag in the storage "sqlite3": a folder with metadata.yaml and one or more .db3 files.

usage: rosbag2_sqlite.py MESSAGES.json OUT_DIR [--split MESSAGES_PER_FILE]

MESSAGES.json comes from mcap.mjs --dump. The tables are those of rosbag2_storage_sqlite3 (schema 3).
"""
import base64
import json
import sqlite3
import sys
from pathlib import Path

from rosbag2_tables import SCHEMA


def main():
    messages, out, options = json.loads(Path(sys.argv[1]).read_text()), Path(sys.argv[2]), sys.argv[3:]
    split = int(options[1]) if options[:1] == ["--split"] else len(messages)
    out.mkdir(parents=True, exist_ok=True)
    topics = sorted({(m["topic"], m["type"]) for m in messages})
    ids = {name: i + 1 for i, (name, _) in enumerate(topics)}
    files = []
    for first in range(0, len(messages), split):
        file = out / f"{out.name}_{len(files)}.db3"
        file.unlink(missing_ok=True)
        files.append(file.name)
        with sqlite3.connect(file) as db:
            db.executescript(SCHEMA)
            db.executemany("INSERT INTO topics VALUES (?, ?, ?, 'cdr', '')", [(ids[n], n, t) for n, t in topics])
            db.executemany("INSERT INTO messages(topic_id, timestamp, data) VALUES (?, ?, ?)",
                           [(ids[m["topic"]], int(m["ns"]), base64.b64decode(m["data"]))
                            for m in messages[first:first + split]])
    listed = "".join(f"    - {name}\n" for name in files)
    (out / "metadata.yaml").write_text(
        "rosbag2_bagfile_information:\n  version: 5\n  storage_identifier: sqlite3\n  relative_file_paths:\n" + listed +
        f"  message_count: {len(messages)}\n  compression_format: \"\"\n  compression_mode: \"\"\n")


main()
