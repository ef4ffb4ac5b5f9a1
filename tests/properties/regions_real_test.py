#!/usr/bin/env python3
"""A real country compiled in regions, in random order, has the bytes and the ledger of one run.

By hand, other places and tiles at levels: regions_real_test.py --place andorra [--emit kiln,glb --lods 2.5] [--region 4096] [--bbox W,S,E,N]
[--keep FOLDER]
"""
import argparse
import json
import random
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "exporters" / "kiln"))

from citykiln_program import DATA, bytes_of_outputs, report_of, run
from manifest_page_test import Manifest

PLACES = {
    "liechtenstein": ("liechtenstein/liechtenstein-2015.osm.pbf", "liechtenstein/N47E009.hgt.zip"),
    "neubrandenburg": ("neubrandenburg/neubrandenburg.osm.bz2",),
    "andorra": ("andorra/andorra-2023.osm.pbf", "andorra/N42E001.hgt"),
    "porto": ("porto-roads/porto_portugal.osm.pbf",),
}


# boundaries that are no areas are in no region's file; relations that are no areas are in none either
# elements farther outside of the extent than the halo are in no region (compiler/regions/regions.md)
# spans of power lines are counted by the region of their way, which knows the supports within its halo only
NOT_IN_REGIONS = {"source/area", "map/unread", "UnknownKind", "wires/span", "OutsideBounds", "BrokenArea", "IncompleteArea", "MissingMember", "RelationWithoutTags"}


def within_bounds(account):
    """An account without what lies outside of the extent."""
    if account is None:
        return None
    outside = account["dropped"].get("OutsideBounds", 0)
    dropped = {reason: count for reason, count in account["dropped"].items() if reason != "OutsideBounds"}
    return {**account, "in": account["in"] - outside, "dropped": dropped}


def first_difference(one, other):
    """Names the first stream of the first tile in which two manifests differ; nothing if none does."""
    chunks, others = (Manifest(path.read_bytes()).chunks for path in (one, other))
    if chunks.keys() != others.keys():
        return f"tiles differ: {sorted(chunks.keys() ^ others.keys())[:5]}"
    for tile, chunk in chunks.items():
        for name, stream in chunk.streams.items():
            if stream.data != others[tile].streams[name].data:
                return f"tile {tile[0]}_{tile[1]}: {name}"
    return None


def compiled_apart(folder, inputs, arguments, region):
    """The folder of a plan whose regions were compiled in random order and gathered."""
    plan = folder / "plan"
    done = run("plan", *inputs, *arguments, "--region", region, "-o", plan, "--quiet")
    if done.returncode:
        raise RuntimeError(done.stderr)
    names = [each["region"] for each in json.loads((plan / "plan.json").read_text())["regions"]]
    random.Random(5).shuffle(names)
    for name in names:
        done = run("compile", "--plan", plan, "--region", name, "--threads", "1", "--quiet")
        if done.returncode:
            raise RuntimeError(f"region {name}: {done.stderr}")
    done = run("gather", plan)
    if done.returncode:
        raise RuntimeError(done.stdout + done.stderr)
    return plan


def differences(folder, place, arguments, region):
    """Lines that say what differs between one run and one in regions."""
    path, *dem = (str(DATA / name) for name in PLACES[place])
    inputs = [path, *(["--dem", *dem] if dem else [])]
    whole = folder / "whole"
    done = run("compile", *inputs, *arguments, "-o", whole, "--quiet")
    if done.returncode:
        raise RuntimeError(done.stderr)
    out = compiled_apart(folder, inputs, arguments, region) / "out"
    lines = []
    if difference := first_difference(whole / "scene.kiln", out / "scene.kiln"):
        lines.append(difference)
    one, other = bytes_of_outputs(whole), bytes_of_outputs(out)
    lines += [f"file {name}" for name in sorted(one.keys() | other.keys()) if one.get(name) != other.get(name)]
    ours, theirs = report_of(whole), report_of(out)
    lines += [f"account {name}: {ours['ledger'].get(name)} in one run, {theirs['ledger'].get(name)} in regions"
              for name in sorted(ours["ledger"].keys() | theirs["ledger"].keys())
              if within_bounds(ours["ledger"].get(name)) != within_bounds(theirs["ledger"].get(name)) and name not in NOT_IN_REGIONS]
    counts = [{name: each["count"] for name, each in report["diagnoses"].items()} for report in (ours, theirs)]
    lines += [f"diagnosis {name}: {counts[0].get(name, 0)} in one run, {counts[1].get(name, 0)} in regions"
              for name in sorted(counts[0].keys() | counts[1].keys())
              if counts[0].get(name) != counts[1].get(name) and name not in NOT_IN_REGIONS]
    return lines


class RegionsReal(unittest.TestCase):
    def test_a_country_in_regions_has_the_bytes_and_the_ledger_of_one_run(self):
        if not (DATA / PLACES["liechtenstein"][0]).exists():
            self.skipTest("real data are missing")
        with tempfile.TemporaryDirectory(prefix="citykiln_") as folder:
            self.assertEqual(differences(Path(folder), "liechtenstein", ["--emit", "kiln"], 4096), [])


def run_by_hand(options):
    arguments = ["--emit", options.emit]
    for name in ("lods", "bbox"):
        if getattr(options, name):
            arguments += [f"--{name}", getattr(options, name)]
    with tempfile.TemporaryDirectory(prefix="citykiln_") as scratch:
        folder = Path(options.keep or scratch)
        folder.mkdir(parents=True, exist_ok=True)
        lines = differences(folder, options.place, arguments, options.region)
        print("\n".join(lines[:40]))
        print(f"{options.place}: {len(lines)} differences")
        return 1 if lines else 0


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--place", choices=sorted(PLACES))
    parser.add_argument("--emit", default="kiln")
    parser.add_argument("--lods")
    parser.add_argument("--bbox")
    parser.add_argument("--region", type=int, default=4096)
    parser.add_argument("--keep")
    chosen, _ = parser.parse_known_args()
    if chosen.place:
        sys.exit(run_by_hand(chosen))
    unittest.main()
