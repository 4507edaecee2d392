#!/usr/bin/env python3
"""A bag of ROS 1 of what prepare.py made.

usage: ros1_bag.py PREPARED_DIR OUT.bag none|bz2|lz4 [--robot] [--compressed] [--chunk BYTES] [--unclosed]
"""
import json
import sys
from pathlib import Path

import genpy
import rosbag
from geometry_msgs.msg import TransformStamped
from nav_msgs.msg import Odometry
from sensor_msgs.msg import CameraInfo, CompressedImage, Image, Imu
from tf2_msgs.msg import TFMessage

COLOR = "camera_color_optical_frame"


def transform(parent, child, xyz, xyzw):
    t = TransformStamped()
    t.header.frame_id, t.child_frame_id = parent, child
    t.transform.translation.x, t.transform.translation.y, t.transform.translation.z = xyz
    t.transform.rotation.x, t.transform.rotation.y, t.transform.rotation.z, t.transform.rotation.w = xyzw
    return t


def header(message, stamp, frame):
    message.header.stamp, message.header.frame_id = stamp, frame
    return message


def write_robot(bag, stamp, i):
    odometry = header(Odometry(), stamp, "odom")
    odometry.child_frame_id = "base_link"
    odometry.pose.pose.position.x = 0.5 * i
    odometry.pose.pose.orientation.z, odometry.pose.pose.orientation.w = 0.6, 0.8
    odometry.twist.twist.linear.x = 0.25
    odometry.twist.twist.angular.z = -0.125
    bag.write("/odom", odometry, stamp)
    imu = header(Imu(), stamp, "imu_link")
    imu.orientation_covariance[0] = -1
    imu.angular_velocity.y = 0.5
    imu.linear_acceleration.z = 9.75
    bag.write("/imu", imu, stamp)


def main():
    prepared, out, packing, options = Path(sys.argv[1]), sys.argv[2], sys.argv[3], sys.argv[4:]
    about = json.loads((prepared / "frames.json").read_text())
    chunk = int(options[options.index("--chunk") + 1]) if "--chunk" in options else 768 * 1024
    bag = rosbag.Bag(out, "w", compression=packing, chunk_threshold=chunk)
    for i, frame in enumerate(about["frames"]):
        ns = int(frame["stamp_ns"])
        stamp = genpy.Time(ns // 10**9, ns % 10**9)
        if i == 0 and "--robot" in options:
            bag.write("/tf_static", TFMessage([transform("base_link", "camera_link", (0.25, 0, 1.5), (0, 0, 0, 1)),
                                               transform("camera_link", COLOR, (0, 0, 0), (-0.5, 0.5, -0.5, 0.5))]), stamp)
        info = header(CameraInfo(), stamp, COLOR)
        info.width, info.height, info.K = about["width"], about["height"], about["k"]
        info.distortion_model, info.D = "plumb_bob", [0.0] * 5
        info.R = [1, 0, 0, 0, 1, 0, 0, 0, 1]
        k = about["k"]
        info.P = [k[0], 0, k[2], 0, 0, k[4], k[5], 0, 0, 0, 1, 0]
        bag.write("/camera/color/camera_info", info, stamp)
        for topic, encoding, channel_bytes, raw, png in (
                ("/camera/color/image_raw", "rgb8", 3, "color", "colorPng"),
                ("/camera/aligned_depth_to_color/image_raw", "16UC1", 2, "depth", "depthPng")):
            if "--compressed" in options:
                message = header(CompressedImage(), stamp, COLOR)
                depth = channel_bytes == 2
                message.format = "16UC1; compressedDepth" if depth else "rgb8; png compressed bgr8"
                message.data = bytes(12 if depth else 0) + (prepared / frame[png]).read_bytes()
                bag.write(topic + ("/compressedDepth" if depth else "/compressed"), message, stamp)
                continue
            message = header(Image(), stamp, COLOR)
            message.width, message.height, message.encoding = about["width"], about["height"], encoding
            message.step = channel_bytes * about["width"]
            message.data = (prepared / frame[raw]).read_bytes()
            bag.write(topic, message, stamp)
        if "--robot" in options:
            write_robot(bag, stamp, i)
    if "--unclosed" in options:
        bag._file.flush()
        import os
        os._exit(0)  # as if the recorder had been killed
    bag.close()


main()
