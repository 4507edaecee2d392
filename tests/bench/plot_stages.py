#!/usr/bin/env python3
"""Where tracking's time goes, image by image: bars of two builds, as a picture (SVG).

usage: plot_stages.py PICTURE.svg OUT
  OUT  folder in which compare_builds.py has left its runs: those of the last pair are drawn, at the camera's rate
"""

import json
import sys
from pathlib import Path

# stage of summary.json: what it is called, colour; the rest of pipeline.process is what no stage of an old build tells
STAGES = {"sources.build_frame": ("frame", "#94a3b8"), "filters.begin": ("filters begin", "#fdba74"),
          "features.extract": ("key points", "#1d4ed8"), "filters.apply": ("filters", "#c2410c"),
          "filters.annotate": ("annotation", "#a16207"), "odometry.track": ("pose", "#15803d"),
          "filters.end": ("filters end", "#fed7aa")}
REST = ("rest", "#d1d5db")
WIDTH, LEFT, RIGHT, BAR, GAP, TOP, FOOT = 900, 190, 90, 22, 20, 14, 74


def parts_of(summary):
    """Milliseconds, each stage by its median, so that their sum is near the median of all of it."""
    stages = summary["stages"]
    whole_ms = stages["pipeline.process"]["median_ms"]
    parts = [(name, colour, stages[stage]["median_ms"]) for stage, (name, colour) in STAGES.items() if stage in stages]
    return whole_ms, parts + [(*REST, max(0.0, whole_ms - sum(ms for _, _, ms in parts)))]


def bars(out):
    for folder in sorted((out / "runs").iterdir()):
        for which in ("old", "new"):
            file = folder / which / "paced/summary.json"
            if file.exists():
                yield folder.name, which, *parts_of(json.loads(file.read_text(encoding="utf-8")))


def legend(names, y):
    x, lines = LEFT, []
    for name, colour in names:
        lines.append(f'<rect x="{x}" y="{y}" width="12" height="12" fill="{colour}"/>'
                     f'<text x="{x + 17}" y="{y + 10}">{name}</text>')
        x += 34 + 7 * len(name)
    return lines


def picture(all_bars):
    longest_ms = max(whole_ms for _, _, whole_ms, _ in all_bars)
    scale = (WIDTH - LEFT - RIGHT) / longest_ms
    lines, y, before = [], TOP, None
    for sequence, which, whole_ms, parts in all_bars:
        y += GAP if before not in (None, sequence) else 0
        before, x = sequence, LEFT
        lines.append(f'<text x="{LEFT - 10}" y="{y + 16}" text-anchor="end">{sequence}, {which}</text>')
        for name, colour, ms in parts:
            lines.append(f'<rect x="{x:.1f}" y="{y}" width="{ms * scale:.1f}" height="{BAR}" fill="{colour}">'
                         f"<title>{name}: {ms:.1f} ms</title></rect>")
            x += ms * scale
        lines.append(f'<text x="{x + 8:.1f}" y="{y + 16}">{whole_ms:.1f} ms</text>')
        y += BAR + 4
    names = list(dict.fromkeys((name, colour) for *_, parts in all_bars for name, colour, ms in parts if ms * scale > 1))
    lines += legend(names, y + 18)
    height = y + FOOT - 24
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" font-family="sans-serif" '
            f'font-size="13"><rect width="{WIDTH}" height="{height}" fill="white"/>' + "\n".join(lines) + "</svg>\n")


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    all_bars = list(bars(Path(sys.argv[2])))
    if not all_bars:
        sys.exit(f"{sys.argv[2]}: no runs of compare_builds.py are there")
    Path(sys.argv[1]).write_text(picture(all_bars), encoding="utf-8")


if __name__ == "__main__":
    main()
