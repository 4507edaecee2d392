#!/usr/bin/env python3
"""A recording of ROS 2 as RealSense's own recorder (librealsense from 2.57 on) writes it, of what prepare.py made.

usage: realsense_db3.py PREPARED_DIR OUT.db3

Topics, types and frames are called as there: calibrations, places (how a point of the device is seen by the stream, the
matrix column by column) and the unit of depth are texts, without a time; messages are packed one by one by zstd, which no
metadata.yaml tells of.
"""
import json
import sqlite3
import struct
import subprocess
import sys
from pathlib import Path

from rosbag2_tables import SCHEMA

STATIC_NS = -2**63


class Cdr:
    """Little-endian; numbers lie at multiples of their size, counted from behind the header."""

    def __init__(self):
        self.bytes = b""

    def put(self, code, value):
        size = struct.calcsize(code)
        self.bytes += b"\0" * (-len(self.bytes) % size) + struct.pack("<" + code, value)
        return self

    def text(self, value):
        raw = value.encode() + b"\0"
        self.put("I", len(raw)).bytes += raw
        return self

    def packed(self):
        message = b"\0\1\0\0" + self.bytes
        return subprocess.run(["zstd", "-q", "-1", "-c"], input=message, stdout=subprocess.PIPE, check=True).stdout


def image(about, stamp_ns, frame, encoding, step, raw):
    message = Cdr().put("i", stamp_ns // 10**9).put("I", stamp_ns % 10**9).text(frame)
    message.put("I", about["height"]).put("I", about["width"]).text(encoding).put("B", 0).put("I", step)
    message.put("I", len(raw)).bytes += raw
    return message


def messages(prepared):
    about = json.loads((prepared / "frames.json").read_text())
    text, picture = "std_msgs/msg/String", "sensor_msgs/msg/Image"
    depth, color = "/device_0/sensor_0/Depth_0", "/device_0/sensor_1/Color_0"
    yield "/device_0/sensor_0/option/Depth_Units/value", text, STATIC_NS, Cdr().text("0.000100")
    for stream, focal, lens, x in ((depth, 50, "Brown Conrady", "0"), (color, 52.5, "Inverse Brown Conrady", "-0.015000")):
        size = f"width={about['width']};height={about['height']}"
        matrix = f"fx={focal};ppx={about['k'][2]};fy={focal};ppy={about['k'][5]}"
        yield stream + "/camera_info", text, STATIC_NS, Cdr().text(f"{size};{matrix};model={lens};coeffs=0,0,0,0,0")
        place = f"rotation=1.000000,0,0,0,1.000000,0,0,0,1.000000;translation={x},0,0"
        yield stream + "/tf/ref_0", text, STATIC_NS, Cdr().text(place)
    for frame in about["frames"]:
        ns = int(frame["stamp_ns"])
        for stream, encoding, pixel_bytes, raw in ((depth, "mono16", 2, "depth"), (color, "rgb8", 3, "color")):
            raw_bytes = (prepared / frame[raw]).read_bytes()
            name = stream.split("/")[-1].split("_")[0]
            yield stream + "/image/data", picture, ns, image(about, ns, name, encoding, pixel_bytes * about["width"], raw_bytes)


def main():
    prepared, out = Path(sys.argv[1]), Path(sys.argv[2])
    out.unlink(missing_ok=True)
    ids = {}
    with sqlite3.connect(out) as db:
        db.executescript(SCHEMA)
        for topic, kind, stamp_ns, message in messages(prepared):
            if topic not in ids:
                ids[topic] = len(ids) + 1
                db.execute("INSERT INTO topics VALUES (?, ?, ?, 'cdr', '')", (ids[topic], topic, kind))
            db.execute("INSERT INTO messages(topic_id, timestamp, data) VALUES (?, ?, ?)",
                       (ids[topic], stamp_ns, message.packed()))


main()
