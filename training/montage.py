"""Pictures of generated scenes (depth as measured above, classes below): montage.py FILE.png [SEED] [ROWS x COLUMNS pictures]"""
import sys

import cv2
import numpy as np
import torch

from depthnet import sensor
from depthnet.generator import Generator

PALETTE = np.array([[70, 70, 70], [0, 0, 255], [0, 200, 255], [0, 120, 200], [255, 160, 60], [120, 200, 120], [255, 0, 255],
                    [0, 255, 0], [255, 255, 0], [180, 100, 255], [200, 200, 120], [90, 140, 255], [0, 90, 90], [0, 160, 0],
                    [255, 200, 200], [200, 0, 120], [160, 255, 255], [100, 60, 160]], np.uint8)


def depth_picture(depth):
    value = np.clip((1 / np.maximum(depth, 0.3) - 0.1) / 1.3, 0, 1) ** 0.7 * 255
    picture = cv2.applyColorMap(value.astype(np.uint8), cv2.COLORMAP_TURBO)
    picture[depth <= 0] = 0
    return picture


def class_picture(classes, depth):
    return (PALETTE[classes] * np.clip(1.1 - depth[..., None] / 12, 0.3, 1)).astype(np.uint8)


def write(path, measured, labels, truth, columns=6):
    columns = min(columns, len(truth))
    tiles = [np.vstack([depth_picture(m), class_picture(l, t)]) for m, l, t in zip(measured, labels, truth)]
    rows = [np.hstack(tiles[k:k + columns]) for k in range(0, len(tiles) - columns + 1, columns)]
    cv2.imwrite(path, np.vstack(rows))


if __name__ == "__main__":
    seed = int(sys.argv[2]) if len(sys.argv) > 2 else 1
    count = int(sys.argv[3]) if len(sys.argv) > 3 else 24
    torch.manual_seed(seed)
    generator = Generator("cpu", count, seed)
    depth, labels, instances, material, cameras = generator.cast(*generator.scene_batch())
    measured, labels = sensor.measure(depth, labels, material)
    write(sys.argv[1], measured.numpy(), labels.numpy(), depth.numpy())
