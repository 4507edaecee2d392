#!/usr/bin/env python3
"""A bag as RealSense's own recorder (librealsense, RealSense Viewer) writes it, of what prepare.py made.

usage: realsense_bag.py PREPARED_DIR OUT.bag

Topics, types, frames and lenses are called as there: depth is "mono16", all frames are "0", places are
geometry_msgs/Transform (how a point of the device is seen by the stream), and the unit of depth is an option.
"""
import json
import sys
from pathlib import Path

import genpy
import rosbag
from geometry_msgs.msg import Transform
from sensor_msgs.msg import CameraInfo, Image
from std_msgs.msg import Float32, UInt32

STATIC = genpy.Time(0, 1)


def info(about, focal, lens):
    message = CameraInfo()
    message.width, message.height = about["width"], about["height"]
    message.K = [focal, 0, about["k"][2], 0, focal, about["k"][5], 0, 0, 1]
    message.D, message.distortion_model = [0.0] * 5, lens
    return message


def place(x):
    message = Transform()
    message.translation.x, message.rotation.w = x, 1.0
    return message


def main():
    prepared, out = Path(sys.argv[1]), sys.argv[2]
    about = json.loads((prepared / "frames.json").read_text())
    depth, color = "/device_0/sensor_0/Depth_0", "/device_0/sensor_1/Color_0"
    with rosbag.Bag(out, "w", compression="lz4") as bag:
        bag.write("/file_version", UInt32(4), STATIC)
        bag.write("/device_0/sensor_0/option/Depth_Units/value", Float32(0.0001), STATIC)
        for stream, focal, lens, x in ((depth, 50.0, "Brown Conrady", 0.0), (color, 52.5, "Inverse Brown Conrady", -0.015)):
            bag.write(stream + "/info/camera_info", info(about, focal, lens), STATIC)
            bag.write(stream + "/tf/0", place(x), STATIC)
        for frame in about["frames"]:
            ns = int(frame["stamp_ns"])
            stamp = genpy.Time(ns // 10**9, ns % 10**9)
            for stream, encoding, channel_bytes, raw in ((depth, "mono16", 2, "depth"), (color, "rgb8", 3, "color")):
                message = Image()
                message.header.stamp, message.header.frame_id = stamp, "0"
                message.width, message.height, message.encoding = about["width"], about["height"], encoding
                message.step = channel_bytes * about["width"]
                message.data = (prepared / frame[raw]).read_bytes()
                bag.write(stream + "/image/data", message, stamp)


main()
