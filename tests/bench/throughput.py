#!/usr/bin/env python3
"""Measures how fast plans of real extracts are compiled by one and by two processes, and draws that. By hand, on an idle machine:

    tests/bench/throughput.py FOLDER [--places monaco,boston,…]

Writes FOLDER/throughput.csv and, with gnuplot, throughput.svg. A row is a place, a set of levels and a number of processes (ninja -j): area
of the extent, regions, seconds of wall time with `gather`, and square kilometres a second. The tasks of a plan are run with an empty
folder of outputs each time.
"""
import argparse
import csv
import json
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "properties"))
from citykiln_program import DATA, run  # noqa: E402

# map, heights, box where the header has none or more than the place, side of a region in metres
PLACES = {
    "canillo": ("andorra/cut-canillo-village.osm.pbf", "andorra/N42E001.hgt", "1.560,42.553,1.620,42.590", 2048),
    "andorra-la-vella": ("andorra/cut-andorra-la-vella.osm.pbf", "andorra/N42E001.hgt", "1.500,42.495,1.545,42.520", 2048),
    "neubrandenburg": ("neubrandenburg/neubrandenburg.osm.bz2", "", "13.23,53.54,13.29,53.58", 2048),
    "monaco": ("monaco/monaco-2023.osm.pbf", "monaco/N43E007.hgt", "", 1024),
    "boston": ("boston-back-bay/back_bay.osm.pbf", "", "-71.092,42.342,-71.066,42.356", 1024),
    "chicago": ("chicago-loop/chicago_loop.osm.pbf", "", "-87.6384,41.8676,-87.6054,41.8907", 1024),
}
LEVELS = {"0.1 m": "0.1", "all levels": "0.1,0.5,1.2,2.5,12.5"}
PROCESSES = (1, 2)

CHART = """\
set terminal svg size 760,420 font 'sans,12'
set output '{folder}/throughput.svg'
set datafile separator ','
set style data histograms
set style fill solid 0.9 noborder
set boxwidth 0.9
set ylabel 'km² a second'
set key top right
set xtics rotate by -20 nomirror
set grid ytics
plot '{folder}/chart.csv' using 2:xtic(1) title '0.1 m, one process', '' using 3 title '0.1 m, two processes', \\
  '' using 4 title 'all levels, one process', '' using 5 title 'all levels, two processes'
"""


def planned(place, levels, folder):
    """The area in km² and the number of regions."""
    map_path, dem, box, region_m = PLACES[place]
    done = run("plan", DATA / map_path, *(["--dem", DATA / dem] if dem else []), *([f"--bbox={box}"] if box else []), "--region", region_m,
               "--lods", levels, "-o", folder, "--quiet")
    if done.returncode != 0:
        raise SystemExit(f"{place}: {done.stderr}")
    plan = json.loads((folder / "plan.json").read_text())
    west, south, east, north = plan["extent_m"]
    return (east - west) * (north - south) * 1e-6, len(plan["regions"])


def seconds_of(folder, processes):
    for name in ("regions", "state", "out", ".ninja_log", ".ninja_deps"):
        path = folder / name
        shutil.rmtree(path, ignore_errors=True)
        path.unlink(missing_ok=True)
    begin = time.monotonic()
    done = subprocess.run(["ninja", "-C", str(folder), f"-j{processes}"], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise SystemExit(done.stdout[-2000:])
    return time.monotonic() - begin


def rows_of(place):
    for name, levels in LEVELS.items():
        with tempfile.TemporaryDirectory(prefix="citykiln_") as scratch:
            folder = Path(scratch) / "plan"
            area_km2, regions = planned(place, levels, folder)
            for processes in PROCESSES:
                seconds = seconds_of(folder, processes)
                yield [place, name, processes, f"{area_km2:.2f}", regions, f"{seconds:.1f}", f"{area_km2 / seconds:.3f}"]


def draw(rows, folder):
    speeds = {(place, levels, processes): speed for place, levels, processes, _, _, _, speed in rows}
    places = list(dict.fromkeys(row[0] for row in rows))
    with open(folder / "chart.csv", "w", encoding="utf-8") as out:
        for place in places:
            out.write(",".join([place, *(speeds[place, levels, processes] for levels in LEVELS for processes in PROCESSES)]) + "\n")
    subprocess.run(["gnuplot"], input=CHART.format(folder=folder), text=True, check=True)
    (folder / "chart.csv").unlink()


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("folder", type=Path)
    arguments.add_argument("--places", default=",".join(PLACES))
    request = arguments.parse_args()
    request.folder.mkdir(parents=True, exist_ok=True)
    rows = []
    for place in request.places.split(","):
        for row in rows_of(place):
            print(*row, flush=True)
            rows.append(row)
    with open(request.folder / "throughput.csv", "w", newline="", encoding="utf-8") as out:
        csv.writer(out).writerows([["place", "levels", "processes", "km2", "regions", "seconds", "km2_per_s"], *rows])
    if shutil.which("gnuplot"):
        draw(rows, request.folder)


if __name__ == "__main__":
    main()
