#!/usr/bin/env python3
"""A ROS 2 bag whose messages are packed one by one (compression_mode MESSAGE), of one that is not.

usage: rosbag2_zstd.py SQLITE_DIR OUT_DIR

Every message is packed by the program zstd, as rosbag2 does it with the library.
"""
import sqlite3
import subprocess
import sys
from pathlib import Path


def packed(message):
    return subprocess.run(["zstd", "-q", "-c"], input=message, stdout=subprocess.PIPE, check=True).stdout


def main():
    source, out = Path(sys.argv[1]), Path(sys.argv[2])
    out.mkdir(parents=True, exist_ok=True)
    file = out / f"{out.name}_0.db3"
    file.unlink(missing_ok=True)
    parts = sorted(source.glob("*.db3"))
    with sqlite3.connect(file) as db:
        with sqlite3.connect(parts[0]) as first:
            for (statement,) in first.execute("SELECT sql FROM sqlite_master WHERE sql IS NOT NULL"):
                db.execute(statement)
            db.executemany("INSERT INTO topics VALUES (?, ?, ?, ?, ?)", first.execute("SELECT * FROM topics"))
        for part in parts:
            with sqlite3.connect(part) as other:
                for topic, stamp, data in other.execute("SELECT topic_id, timestamp, data FROM messages ORDER BY id"):
                    db.execute("INSERT INTO messages(topic_id, timestamp, data) VALUES (?, ?, ?)", (topic, stamp, packed(data)))
    (out / "metadata.yaml").write_text(
        "rosbag2_bagfile_information:\n  version: 5\n  storage_identifier: sqlite3\n  relative_file_paths:\n"
        f"    - {file.name}\n  compression_format: zstd\n  compression_mode: MESSAGE\n")


main()
