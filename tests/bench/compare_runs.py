#!/usr/bin/env python3
"""Runs two builds of citykiln in turn on real places and prints a table of CPU seconds, memory, bytes and triangles.

    compare_runs.py BASE BRANCH [ROUNDS]

Each figure is the median over the rounds. CPU seconds are user and system time of all threads. A ratio is the median of
BRANCH / BASE over the rounds, so what slows the whole machine down for a while counts in both. Files that hold times
(timing.json) are not counted. A row whose outputs differ says so; equal rows have the same bytes in every file.
"""
import hashlib
import json
import os
import statistics
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
DATA = ROOT.parent / "shared" / "data"
MONACO = [DATA / "monaco/monaco-2023.osm.pbf", "--dem", DATA / "monaco/N43E007.hgt"]
CHICAGO = [DATA / "chicago-loop/chicago_loop.osm.pbf"]
ANDORRA = [DATA / "andorra/andorra-2023.osm.pbf", "--dem", DATA / "andorra/N42E001.hgt"]
PICTURE = ["--view", "street", "--size", "640x360", "--spp", "8", "-o"]

# Name, words of the command, folder of the outputs. A command may read the folders of rows above it.
ROWS = [
    ("Monaco, 0.1 m", ["compile", *MONACO, "--lods", "0.1", "-o", "monaco_fine"], "monaco_fine"),
    ("Monaco, default levels", ["compile", *MONACO, "-o", "monaco"], "monaco"),
    ("Chicago, 0.5 m", ["compile", *CHICAGO, "--lods", "0.5", "-o", "chicago"], "chicago"),
    ("Andorra, manifest", ["compile", *ANDORRA, "--emit", "kiln", "-o", "andorra"], "andorra"),
    ("preview of tiles", ["preview", "chicago", "--level", "0", *PICTURE, "tiles.png"], None),
    ("preview of recipes", ["preview", "chicago/scene.kiln", "--tolerance", "0.5", *PICTURE, "recipes.png"], None),
    ("check of Monaco, 0.1 m", ["check", "monaco_fine"], None),
]


@dataclass
class Measured:
    cpu_s: float
    memory_mb: float
    megabytes: float | None = None
    triangles: int | None = None
    hashes: str = ""


def measure(program, words, folder, scratch):
    """Runs a command in a folder and measures the process and the files it leaves."""
    with open(scratch / "output.txt", "w") as output:
        process = subprocess.Popen([program, *map(str, words)], cwd=scratch, stdout=output, stderr=output)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        print(f"{program} {words[0]} ends with {process.returncode}: {(scratch / 'output.txt').read_text()[-300:]}", file=sys.stderr)
    measured = Measured(usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1000)
    if folder:
        files = [path for path in (scratch / folder).rglob("*") if path.is_file() and path.name != "timing.json"]
        measured.megabytes = sum(path.stat().st_size for path in files) / 1e6
        measured.triangles = sum(level["triangles"] for level in json.loads((scratch / folder / "report.json").read_text())["levels"])
        outputs = sorted(path for path in files if path.suffix in (".kiln", ".glb"))
        measured.hashes = json.dumps([(path.name, hashlib.sha256(path.read_bytes()).hexdigest()) for path in outputs])
    return measured


def column(pairs, value, digits):
    """The medians of both builds and the median of their ratios."""
    base, branch = ([getattr(measured, value) for measured in side] for side in zip(*pairs))
    if base[0] is None:
        return "", "", ""
    ratio = statistics.median(b / a if a else 1 for a, b in zip(base, branch))
    return f"{statistics.median(base):.{digits}f}", f"{statistics.median(branch):.{digits}f}", f"{ratio:.2f}"


def main():
    programs = [str(Path(path).resolve()) for path in sys.argv[1:3]]
    rounds = int(sys.argv[3]) if len(sys.argv) > 3 else 3
    if not DATA.exists():
        sys.exit(f"{DATA} is missing")
    print("| run | CPU s | | ratio | MB of memory | | ratio | MB out | | ratio | triangles | | ratio | same bytes |")
    print("|---|" + "---|" * 13, flush=True)
    with tempfile.TemporaryDirectory(prefix="citykiln_compare_") as scratch:
        sides = [Path(scratch) / name for name in ("base", "branch")]
        for side in sides:
            side.mkdir()
        for name, words, folder in ROWS:
            pairs = [[measure(program, words, folder, side) for program, side in zip(programs, sides)] for _ in range(rounds)]
            cells = [cell for value, digits in (("cpu_s", 1), ("memory_mb", 0), ("megabytes", 1), ("triangles", 0))
                     for cell in column(pairs, value, digits)]
            same = "" if not folder else "yes" if all(a.hashes == b.hashes for a, b in pairs) else "no"
            print(f"| {name} | " + " | ".join(cells) + f" | {same} |", flush=True)


if __name__ == "__main__":
    main()
