#!/usr/bin/env python3
"""Measures what regions of real extracts cost, for compiler/commands/plan/expected_cost.cpp. By hand:

    tests/bench/measure_cost.py runs.jsonl [--rounds 4] [--check]

Each round plans every place with the next size of regions, draws two and compiles each at all default levels at once and at one at a
time; with --check, the places that the model is not fitted to, at all default levels. A line is the region's entry in plan.json with what its task took: seconds
of processor time for planning and baking, largest memory, bytes of outputs. fit_cost.py reads the lines.
"""
import argparse
import json
import os
import random
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "properties"))
from citykiln_program import DATA, PROGRAM, run  # noqa: E402

FITTED = {
    "monaco/monaco-2023.osm.pbf": "monaco/N43E007.hgt",
    "andorra/cut-canillo-village.osm.pbf": "andorra/N42E001.hgt",
    "chicago-loop/chicago_loop.osm.pbf": "",
    "neubrandenburg/neubrandenburg.osm.bz2": "",
    "berlin/berlin-reinickendorf-2026.osm.pbf": "berlin/N52E013.hgt",
    "st-moritz/st-moritz.osm.gz": "st-moritz/N46E009.hgt.zip",
    "kyoto-fushimi/kyoto.osm.gz": "",
    "liechtenstein/liechtenstein-2015.osm.pbf": "liechtenstein/N47E009.hgt.zip",
    "los-angeles-north-hills/north-hills.osm.gz": "",
    "niteroi/niteroi.osm.pbf": "",
}
HELD_OUT = {
    "andorra/cut-andorra-la-vella.osm.pbf": "andorra/N42E001.hgt",
    "boston-back-bay/back_bay.osm.pbf": "",
    "helsinki/Helsinki.osm.pbf": "",
    "dublin-docklands/docklands.osm.gz": "",
    "nice-old-town/nice.osm.pbf": "monaco/N43E007.hgt",
    "berlin-adlershof/adlershof.osm.gz": "berlin/N52E013.hgt",
    "baltimore-harbour/baltimore.osm.pbf": "",
    "small/frederiksted.osm.pbf": "",
}
# of extracts whose header has none
BOXES = {
    "andorra/cut-canillo-village.osm.pbf": "1.560,42.553,1.620,42.590",
    "andorra/cut-andorra-la-vella.osm.pbf": "1.500,42.495,1.545,42.520",
    "chicago-loop/chicago_loop.osm.pbf": "-87.6384,41.8676,-87.6054,41.8907",
    "niteroi/niteroi.osm.pbf": "-43.14,-22.92,-43.06,-22.86",
    "boston-back-bay/back_bay.osm.pbf": "-71.092,42.342,-71.066,42.356",
    "small/frederiksted.osm.pbf": "-64.9044,17.6739,-64.8400,17.7300",
}
SIZES = ((1024, 1024, 512), (2048, 1024, 1024), (1024, 512, 2048), (512, 512, 1024))  # region, tile, halo in metres
LEVELS = ("0.1", "0.5", "1.2", "2.5", "12.5")
DEFAULT_LEVELS = ",".join(LEVELS)
REGIONS = 2  # of each plan
MOST_NODES = 10000  # of a region: larger ones take minutes


def plan_of(place, dem, sizes, folder):
    dem_options = ["--dem", DATA / dem] if dem else []
    box_options = [f"--bbox={BOXES[place]}"] if place in BOXES else []
    region_m, tile_m, halo_m = sizes
    done = run("plan", DATA / place, *dem_options, *box_options, "--region", region_m, "--tile", tile_m, "--halo", halo_m, "--lods", DEFAULT_LEVELS, "-o",
               folder)
    if done.returncode != 0:
        print(done.stderr, file=sys.stderr)
        return []
    return json.loads((folder / "plan.json").read_text())["regions"]


def set_levels(folder, levels):
    """Changes the plan's levels; nothing else in its folder depends on them."""
    plan = json.loads((folder / "plan.json").read_text())
    plan["settings"] = [[name, levels if name == "lods" else value] for name, value in plan["settings"]]
    (folder / "plan.json").write_text(json.dumps(plan))


def compile_region(folder, region):
    """Processor seconds of planning and of baking, memory and bytes."""
    task = subprocess.Popen([PROGRAM, "compile", "--plan", folder, "--region", region, "--threads", "1", "--quiet"],
                            stdout=subprocess.DEVNULL, preexec_fn=lambda: os.nice(5))
    _, status, usage = os.wait4(task.pid, 0)
    task.returncode = status
    if status != 0:
        raise SystemExit(f"region {region} failed")
    stages = json.loads((folder / "regions" / region / "timing.json").read_text())["stages"]
    state = json.loads((folder / "state" / f"{region}.json").read_text())
    baked = sum(stage["seconds"] for stage in stages if stage["stage"] == "bake and write") / max(state["seconds"], 1e-3)
    cpu_s = usage.ru_utime + usage.ru_stime
    return {"plan_s": cpu_s * (1 - baked), "bake_s": cpu_s * baked, "memory_bytes": state["memory_bytes"],
            "output_bytes": state["output_bytes"]}


def measure(place, dem, sizes, levels, draw, out):
    with tempfile.TemporaryDirectory(prefix="citykiln_cost_") as scratch:
        folder = Path(scratch) / "plan"
        regions = [region for region in plan_of(place, dem, sizes, folder) if 200 < region["own_way_nodes"] < MOST_NODES]
        for region in draw.sample(regions, min(REGIONS, len(regions))):
            for level in levels:
                set_levels(folder, level)
                line = {"place": place, "levels": level, "region_m": sizes[0], "tile_m": sizes[1], **region,
                        **compile_region(folder, region["region"])}
                out.write(json.dumps(line) + "\n")
                out.flush()
                shutil.rmtree(folder / "regions" / region["region"])


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("runs")
    arguments.add_argument("--rounds", type=int, default=4)
    arguments.add_argument("--check", action="store_true")
    arguments.add_argument("--seed", type=int, default=1)
    request = arguments.parse_args()
    draw = random.Random(request.seed)
    with open(request.runs, "a", encoding="utf-8") as out:
        for step in range(request.rounds):
            places = list((HELD_OUT if request.check else FITTED).items())
            draw.shuffle(places)
            for place, dem in places:
                measure(place, dem, SIZES[step % len(SIZES)], [DEFAULT_LEVELS] if request.check else [DEFAULT_LEVELS, *LEVELS], draw, out)


if __name__ == "__main__":
    main()
