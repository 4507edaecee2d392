"""Writes a small synthetic depth image and the six input channels made of it, for tests of other implementations.

    export_vectors.py DIR [SEED]

DIR/depth.png       176 x 132, 16 bit, 5000 units a metre, 0: nothing measured
DIR/channels.f32    float32, little endian, [6, 66, 88]: the channels of the image halved to 88 x 66
DIR/camera.json     fx, fy, cx, cy [px] of depth.png, and the shape above
"""
import json
import os
import sys

import cv2
import numpy as np
import torch

from depthnet import sensor
from depthnet.generator import Generator
from evaluate import input_channels, reduce_depth

WIDTH, HEIGHT = 176, 132
LEFT, TOP = 72, 54  # of the part of a generated image that is taken


def main(out, seed):
    torch.manual_seed(seed)
    generator = Generator("cpu", 4, seed)
    depth, classes, _, material, cameras = generator.cast(*generator.scene_batch())
    measured, classes = sensor.measure(depth, classes, material)
    part = (slice(TOP, TOP + HEIGHT), slice(LEFT, LEFT + WIDTH))
    people = [(c[part] == 1).sum().item() * (0.3 < (m[part] > 0).float().mean().item() < 0.97) for c, m in zip(classes, measured)]
    k = int(np.argmax(people))
    raw = (measured[k][part].numpy() * 5000).round().astype(np.uint16)
    fx, fy, cx, cy = (float(v[k]) for v in sensor.halved_intrinsics(cameras))
    cx, cy = cx - LEFT, cy - TOP
    channels = input_channels(reduce_depth(raw), fx / 2, fy / 2, (cx + 0.5) / 2 - 0.5, (cy + 0.5) / 2 - 0.5)[0]
    os.makedirs(out, exist_ok=True)
    cv2.imwrite(os.path.join(out, "depth.png"), raw)
    channels.astype("<f4").tofile(os.path.join(out, "channels.f32"))
    with open(os.path.join(out, "camera.json"), "w") as file:
        json.dump({"fx": fx, "fy": fy, "cx": cx, "cy": cy, "depth_units_per_metre": 5000, "channels": list(channels.shape)}, file, indent=1)
        file.write("\n")
    print(f"image {k}: {people[k]} pixels of people, {100 * (raw > 0).mean():.0f} % measured")


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 3)
