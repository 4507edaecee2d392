#!/usr/bin/env python3
"""Does the cost of a keyframe grow with the map? A table on the output, and curves as a picture (SVG).

usage: plot_growth.py PICTURE.svg ROUND_S NAME=LOAD.csv [NAME=LOAD.csv]...
  ROUND_S      how long one round lasts, in seconds of the recording
  LOAD.csv     what `wardslam run` has written of itself; the first one is drawn pale
"""

import csv
import sys
from pathlib import Path

STAGES = ("graph", "mapping", "storage")
PARTS = 30  # of the curves
COLOURS = {"graph": "#1d4ed8", "mapping": "#c2410c", "storage": "#15803d", "all": "#111827"}
WIDTH, PANEL, LEFT, RIGHT, GAP = 900, 190, 64, 150, 52


class Run:
    def __init__(self, name, file):
        self.name = name
        rows = [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file.open())]
        start_s = rows[0]["timestamp"]
        self.rows = [dict(row, time=row["timestamp"] - start_s) for row in rows]
        self.end_s = self.rows[-1]["time"]

    def between(self, from_s, to_s):
        return [row for row in self.rows if from_s < row["time"] <= to_s]

    def per_keyframe(self, stage, from_s, to_s):
        """Milliseconds; None where there is no keyframe."""
        rows = self.between(from_s, to_s)
        keyframes = sum(row["keyframes"] for row in rows)
        names = STAGES if stage == "all" else (stage,)
        return sum(row[name + "_ms"] for row in rows for name in names) / keyframes if keyframes else None

    def curve(self, value):
        """Of each part of the run, in its middle."""
        edges = [self.end_s * part / PARTS for part in range(PARTS + 1)]
        points = [((a + b) / 2, value(a, b)) for a, b in zip(edges, edges[1:])]
        return [(time_s, y) for time_s, y in points if y is not None]

    def memory_mb(self, time_s):
        return next((row["memory_mb"] for row in self.rows if row["time"] >= time_s), self.rows[-1]["memory_mb"])


def table(run, round_s):
    tenth_s = run.end_s / 10
    print(f"{run.name}: {sum(row['keyframes'] for row in run.rows):.0f} keyframes in {run.end_s:.0f} s")
    for stage in STAGES + ("all",):
        first = run.per_keyframe(stage, 0, tenth_s)
        last = run.per_keyframe(stage, run.end_s - tenth_s, run.end_s)
        print(f"  {stage:8} {first:7.1f} ms a keyframe in the first tenth, {last:7.1f} in the last, x {last / first:.2f}")
    rounds = [run.memory_mb(round_s * n) for n in range(1, int(run.end_s / round_s + 1.05))]
    print("  memory after each round, MB: " + ", ".join(f"{mb:.0f}" for mb in rounds))
    print(f"  most spent on taking over, ms in a second: {max(row['apply_ms'] for row in run.rows):.2f}")
    print(f"  most that waited: {max(row['waiting'] for row in run.rows):.0f}")


def nice(most):
    step = 1.0
    while step * 5 < most:
        step *= 10
    while step * 2.5 >= most:
        step /= 2
    return step


class Panel:
    def __init__(self, top, title, end_s, most, round_s):
        self.top, self.end_s = top, end_s
        self.step = nice(most)
        self.most = most * 1.05
        self.parts = [f'<text x="{LEFT}" y="{top - 10}" font-weight="bold">{title}</text>']
        value = 0.0
        while value <= self.most:
            y = self.y(value)
            self.parts.append(f'<path d="M{LEFT},{y:.1f}H{WIDTH - RIGHT}" stroke="#d1d5db"/>')
            self.parts.append(f'<text x="{LEFT - 8}" y="{y + 4:.1f}" text-anchor="end">{value:g}</text>')
            value += self.step
        for n in range(1, int(end_s / round_s + 0.05) + 1):
            x = self.x(min(n * round_s, end_s))
            self.parts.append(f'<path d="M{x:.1f},{top}V{top + PANEL}" stroke="#9ca3af" stroke-dasharray="4 4"/>')

    def x(self, time_s):
        return LEFT + (WIDTH - LEFT - RIGHT) * time_s / self.end_s

    def y(self, value):
        return self.top + PANEL * (1.0 - value / self.most)

    def line(self, points, colour, label, pale):
        way = "L".join(f"{self.x(t):.1f},{self.y(v):.1f}" for t, v in points)
        style = 'stroke-dasharray="2 3" stroke-opacity="0.7"' if pale else 'stroke-width="2"'
        self.parts.append(f'<path d="M{way}" fill="none" stroke="{colour}" {style}/>')
        self.parts.append((self.y(points[-1][1]), colour, label))

    def text(self):
        """With the lines' names beside their ends, one above the other."""
        labels = sorted(part for part in self.parts if isinstance(part, tuple))
        parts = [part for part in self.parts if isinstance(part, str)]
        last_y = -1e9
        for y, colour, label in labels:
            last_y = max(y + 4, last_y + 15)
            parts.append(f'<text x="{WIDTH - RIGHT + 8}" y="{last_y:.1f}" fill="{colour}">{label}</text>')
        return parts


def picture(runs, round_s):
    end_s = max(run.end_s for run in runs)
    curves = {
        (run.name, stage): run.curve(lambda a, b, run=run, stage=stage: run.per_keyframe(stage, a, b))
        for run in runs
        for stage in STAGES + ("all",)
    }
    most_ms = max(v for points in curves.values() for _, v in points)
    most_mb = max(row["memory_mb"] for run in runs for row in run.rows)
    times = Panel(40, "work per keyframe, ms of one core", end_s, most_ms, round_s)
    memory = Panel(40 + PANEL + GAP, "resident memory, MB", end_s, most_mb, round_s)
    for n, run in enumerate(runs):
        pale = n + 1 < len(runs)
        for stage in STAGES + ("all",):
            times.line(curves[(run.name, stage)], COLOURS[stage], f"{stage}, {run.name}", pale)
        memory.line([(row["time"], row["memory_mb"]) for row in run.rows], COLOURS["all"], run.name, pale)
    bottom = 40 + 2 * PANEL + GAP
    parts = times.text() + memory.text()
    parts.append(
        f'<text x="{(LEFT + WIDTH - RIGHT) / 2}" y="{bottom + 30}" text-anchor="middle">'
        f"seconds of the recording, 0 to {end_s:.0f}; a dashed line after each round</text>"
    )
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{bottom + 46}" font-family="sans-serif" '
        'font-size="12"><rect width="100%" height="100%" fill="white"/>\n' + "\n".join(parts) + "\n</svg>\n"
    )


def main():
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    round_s = float(sys.argv[2])
    runs = []
    for argument in sys.argv[3:]:
        name, file = argument.split("=", 1)
        runs.append(Run(name, Path(file)))
    for run in runs:
        table(run, round_s)
    Path(sys.argv[1]).write_text(picture(runs, round_s))


if __name__ == "__main__":
    main()
