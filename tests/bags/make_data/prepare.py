#!/usr/bin/env python3
"""Images as raw pixels for the writers of recordings, and the same images as a TUM folder.

usage: prepare.py (TUM_DIR | --scene) OUT_DIR FRAMES

OUT_DIR/frames.json lists stamps (ns) and files: colour as RGB, depth as little-endian 16 bit millimetres, and both as PNG.
OUT_DIR/tum is the twin: a folder in the layout of the TUM RGB-D benchmark with the same images, depth_factor 1000.
"""
import json
import sys
from decimal import Decimal
from pathlib import Path

from PIL import Image


def made_up(count):
    """A tilted wall with a chequered pattern, 64 x 48 pixels."""
    for i in range(count):
        color = Image.new("RGB", (64, 48))
        depth = Image.new("I;16", (64, 48))
        for y in range(48):
            for x in range(64):
                on = (x + i) // 8 + y // 8
                color.putpixel((x, y), (200, 4 * x, 5 * y) if on % 2 else (40, 80, 120))
                depth.putpixel((x, y), 0 if x < 2 else 1000 + 10 * x + 100 * i)
        yield 1700000000_000000000 + i * 33333333 // 1000 * 1000, color, depth


def from_tum(folder, count):
    lines = [l.split() for l in (folder / "associations.txt").read_text().splitlines() if l and l[0] != "#"]
    for stamp, color, _, depth in lines[:count]:
        raw = Image.open(folder / depth)
        mm = Image.new("I;16", raw.size)
        values = [(v + 2) // 5 for v in raw.getdata()]  # 5000 a metre
        mm.putdata(values)
        yield int(Decimal(stamp) * 10**9), Image.open(folder / color).convert("RGB"), mm


def main():
    source, out, count = sys.argv[1], Path(sys.argv[2]), int(sys.argv[3])
    frames = list(made_up(count) if source == "--scene" else from_tum(Path(source), count))
    for folder in ("raw", "tum/rgb", "tum/depth"):
        (out / folder).mkdir(parents=True, exist_ok=True)
    width, height = frames[0][1].size
    focal, cx, cy = (525.0, 319.5, 239.5) if width == 640 else (52.5, 31.5, 23.5)
    listed, lines = [], []
    for stamp, color, depth in frames:
        text = f"{Decimal(stamp) / 10**9:.6f}"
        for name, image in ((f"rgb/{text}.png", color), (f"depth/{text}.png", depth)):
            image.save(out / "tum" / name)
        (out / f"raw/{text}.rgb").write_bytes(color.tobytes())
        (out / f"raw/{text}.mm").write_bytes(depth.tobytes())
        listed.append({"stamp_ns": str(stamp), "color": f"raw/{text}.rgb", "depth": f"raw/{text}.mm",
                       "colorPng": f"tum/rgb/{text}.png", "depthPng": f"tum/depth/{text}.png"})
        lines.append(f"{text} rgb/{text}.png {text} depth/{text}.png\n")
    (out / "tum/associations.txt").write_text("".join(lines))
    (out / "tum/camera.yaml").write_text(f"width: {width}\nheight: {height}\nfx: {focal}\nfy: {focal}\ncx: {cx}\n"
                                         f"cy: {cy}\ndepth_factor: 1000\nfps: 30\n")
    (out / "frames.json").write_text(json.dumps({"width": width, "height": height, "k": [focal, 0, cx, 0, focal, cy, 0, 0, 1],
                                                 "frames": listed}, indent=1))


main()
