#!/usr/bin/env python3
"""Runs two installed builds in turn on the same recordings and prints how the second compares with the first.

    compare_builds.py OLD NEW DATA OUT [--pairs N] [--only SEQUENCE] [--frames N]

OLD, NEW  prefixes of installations (bin/, lib/, share/); their libraries are found in lib/ and lib/wardslam/
DATA      folder of recordings with masks (docs/benchmark.md): ward_walking, rpy_walk
OUT       folder for runs, for a stretch of a hospital that NEW's rawlog-synth renders once, and for compare.json

Masks are given, all else is what each build ships. A pair is, on each sequence, for either build: a run of one image (from
the start of the process to its end: "start"), a run as fast as it goes, and a run with --realtime. Which build begins changes
from pair to pair. Every figure is a ratio new / old within a pair: median of the pairs [least-most], beside the medians of
both. Frame times are the stage pipeline.process of summary.json, which either build has: all that tracking does for an
image, in --realtime, where nobody waits for the map.

Threads that map give way to all else by themselves: on a computer that does other things, too, tracking may be as fast as
ever and the run wait for its map. So the load before each pair is told; computing times hardly depend on it.
"""
import argparse
import json
import os
import pathlib
import statistics
import subprocess
import sys
import time

HOSPITAL = ["--scene", "hospital", "--route", "lobby", "--rate", "10", "--width", "640", "--height", "480", "--seconds", "15",
            "--tum"]
FREIBURG1 = "share/wardslam/config/cameras/tum_freiburg1.yaml"
# figure: how it is called, digits
FIGURES = {"frame_ms": ("frame, median [ms]", 1), "frame_p95_ms": ("frame, 95th percentile [ms]", 1),
           "start_s": ("start, one image, end [s]", 2), "start_cpu_s": ("the same, computing time [s]", 2), "fps": ("images a second, as fast as it goes", 1),
           "memory_mb": ("memory at most [MB]", 0), "cpu_s": ("computing time of that run [s]", 1),
           "ate_m": ("ATE, RMSE [m]", 4), "coverage": ("share of images with a pose", 3)}


class Build:
    def __init__(self, prefix):
        self.prefix = prefix.resolve()
        places = [str(self.prefix / "lib"), str(self.prefix / "lib/wardslam")]
        self.environment = dict(os.environ, LD_LIBRARY_PATH=":".join(places))

    def command(self, program, arguments):
        return [str(self.prefix / "bin" / program), *map(str, arguments)]

    def said(self, arguments):
        return subprocess.run(self.command("wardslam", arguments), env=self.environment, check=True, capture_output=True,
                              text=True).stdout

    def timed(self, arguments, log):
        """Seconds, and what the process used."""
        with open(log, "w", encoding="utf-8") as said:
            begun_s = time.monotonic()
            process = subprocess.Popen(self.command("wardslam", arguments), env=self.environment, stdout=said, stderr=said)
            _, status, used = os.wait4(process.pid, 0)
            lasted_s = time.monotonic() - begun_s
        process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode != 0:
            sys.exit(f"{' '.join(process.args)} ends with {process.returncode}: see {log}")
        return lasted_s, used


class Sequence:
    def __init__(self, name, folder, masks=None, camera=None):
        self.name = name
        self.folder = folder
        self.masks = masks or folder / "masks"
        self.camera = camera

    def arguments(self, build):
        camera = ["--camera", build.prefix / self.camera] if self.camera else []
        return [self.folder, "--masks", self.masks, *camera]


def computing_s(used):
    return used.ru_utime + used.ru_stime


def measured(build, judge, sequence, out, frames):
    """All figures of one build on one sequence."""
    out.mkdir(parents=True, exist_ok=True)

    limit = ["--max-frames", frames] if frames else []

    def run(name, more):
        lasted_s, used = build.timed(["run", *sequence.arguments(build), "--out", out / name, *more], out / f"{name}.log")
        return lasted_s, used, json.loads((out / name / "summary.json").read_text(encoding="utf-8"))

    start_s, used_to_start, _ = run("start", ["--max-frames", 1])
    _, used, fast = run("fast", limit)
    _, _, paced = run("paced", ["--realtime", *limit])
    stage = paced["stages"]["pipeline.process"]
    errors = json.loads(judge.said(["eval", sequence.folder / "groundtruth.txt", out / "fast/trajectory.txt", "--json"]))
    return {"frame_ms": stage["median_ms"], "frame_p95_ms": stage["p95_ms"], "start_s": start_s,
            "start_cpu_s": computing_s(used_to_start), "fps": fast["fps"], "memory_mb": used.ru_maxrss / 1024.0,
            "cpu_s": computing_s(used), "ate_m": errors["ate"]["rmse"],
            "coverage": fast["coverage"]}


def leave_out_of(file, key):
    lines = file.read_text(encoding="utf-8").splitlines(keepends=True)
    file.write_text("".join(line for line in lines if not line.startswith(key + ":")), encoding="utf-8")


def sequences_of(data, out, build, only):
    hospital = out / "hospital"
    labels = out / "hospital_labels/masks"
    every = [Sequence("ward_walking", data / "ward_walking"), Sequence("rpy_walk", data / "rpy_walk", camera=FREIBURG1),
             Sequence("hospital", hospital, labels)]
    chosen = [sequence for sequence in every if only in (None, sequence.name)]
    if any(sequence.name == "hospital" for sequence in chosen) and not labels.exists():
        subprocess.run(build.command("rawlog-synth", [*HOSPITAL, "-o", hospital]), env=build.environment, check=True,
                       stdout=subprocess.DEVNULL)
        leave_out_of(hospital / "camera.yaml", "readout")  # older builds do not know it
    for sequence in chosen:
        if not (sequence.folder / "groundtruth.txt").exists():
            sys.exit(f"{sequence.folder}: no recording with groundtruth.txt is there")
    return chosen


def line(figure, old, new):
    name, digits = FIGURES[figure]
    middle = [f"{statistics.median(values):.{digits}f}" for values in (old, new)]
    if not all(old):
        return f"| {name} | {middle[0]} | {middle[1]} | – |"
    ratios = [after / before for before, after in zip(old, new)]
    return f"| {name} | {middle[0]} | {middle[1]} | {statistics.median(ratios):.2f} [{min(ratios):.2f}–{max(ratios):.2f}] |"


def table(sequence, pairs):
    loads = sorted(pair["load"] for pair in pairs)
    lines = [f"\n{sequence}, {len(pairs)} pairs; processes that wanted a core before each: {loads[0]:.1f}–{loads[-1]:.1f}\n", "| | old | new | new / old |", "|---|---|---|---|"]
    for figure in FIGURES:
        lines.append(line(figure, [pair["old"][figure] for pair in pairs], [pair["new"][figure] for pair in pairs]))
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in ("old", "new", "data", "out"):
        parser.add_argument(name, type=pathlib.Path, metavar=name.upper())
    parser.add_argument("--pairs", type=int, default=5)
    parser.add_argument("--only", metavar="SEQUENCE")
    parser.add_argument("--frames", type=int, metavar="N", help="of each sequence; all unless told")
    arguments = parser.parse_args()
    if arguments.pairs < 1:
        parser.error("--pairs: at least one")
    builds = {"old": Build(arguments.old), "new": Build(arguments.new)}
    out = arguments.out.resolve()
    out.mkdir(parents=True, exist_ok=True)
    sequences = sequences_of(arguments.data.resolve(), out, builds["new"], arguments.only)
    if not sequences:
        parser.error(f"--only: there is no sequence {arguments.only}")
    pairs = {sequence.name: [] for sequence in sequences}
    for number in range(arguments.pairs):
        for sequence in sequences:
            pair = {"load": os.getloadavg()[0]}
            for which in ("old", "new") if number % 2 == 0 else ("new", "old"):
                pair[which] = measured(builds[which], builds["new"], sequence, out / "runs" / sequence.name / which,
                                       arguments.frames)
            pairs[sequence.name].append(pair)
            (out / "compare.json").write_text(json.dumps(pairs, indent=1), encoding="utf-8")
            print(f"pair {number + 1} of {arguments.pairs}, {sequence.name}", file=sys.stderr, flush=True)
    for name, measured_pairs in pairs.items():
        print(table(name, measured_pairs))


if __name__ == "__main__":
    main()
