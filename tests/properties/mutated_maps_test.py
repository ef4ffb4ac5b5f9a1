#!/usr/bin/env python3
"""Mutated maps, through the whole program at two levels: it neither crashes nor fails an assertion nor takes over 40 s of processor time, each account of the
ledger balances, and what cannot be read is one error line.

By hand, with small real maps too: mutated_maps_test.py --count 2000 [--first N] [--keep FOLDER]
"""
import argparse
import bz2
import gzip
import resource
import signal
import sys
import tempfile
import unittest
from pathlib import Path

from citykiln_program import DATA, report_of, run
from mutated_maps import made_map, mutated

MOST_S = 40
TEST_COUNT = 5
REAL = ["junctions/tiny_roundabout.osm", "junctions/overlapping_service_roads.osm", "junctions/service_road_loop.osm", "small/osmtogeojson-map.osm",
        "small/regglisweiler-10.068_48.135.osm", "small/West-Oakland.osm.bz2", "junctions/fremantle_placement.osm",
        "junctions/bristol_sausage_links.osm"]


def source_of(number, with_real):
    """Every other map is real, as far as real data is there."""
    path = DATA / REAL[number // 2 % len(REAL)]
    if not with_real or number % 2 == 0 or not path.exists():
        return made_map(number)
    data = path.read_bytes()
    return bz2.decompress(data) if path.suffix == ".bz2" else gzip.decompress(data) if path.suffix == ".gz" else data


def balances(account):
    kept = account["out"] + account["merged"] + account["without_body"]
    return account["in"] + account["split"] == kept + sum(account["dropped"].values())


def limit_time():
    """Processor time, which does not depend on what else runs."""
    resource.setrlimit(resource.RLIMIT_CPU, (MOST_S, MOST_S + 1))


def fault_of(path, out):
    """The fault of a run, or None."""
    done = run("compile", path, "-o", out, "--lods", "0.5,12.5", "--threads", "1", "--quiet", preexec_fn=limit_time)
    if done.returncode in (-signal.SIGXCPU, -signal.SIGKILL):
        return f"over {MOST_S} s"
    if done.returncode == 1 and done.stderr.startswith("citykiln: ") and done.stderr.count("\n") == 1:
        return None
    if done.returncode != 0:
        return f"exit code {done.returncode}: {done.stderr[-400:]}"
    if "runtime error" in done.stderr:
        return done.stderr[-400:]
    uneven = [name for name, account in report_of(out)["ledger"].items() if not balances(account)]
    return f"does not balance: {uneven}" if uneven else None


def fault_of_number(number, with_real, keep=None):
    with tempfile.TemporaryDirectory(prefix="citykiln_") as folder:
        path = Path(folder) / "mutated.osm"
        path.write_bytes(mutated(source_of(number, with_real), number))
        fault = fault_of(path, Path(folder) / "out")
        if fault and keep:
            (Path(keep) / f"{number}.osm").write_bytes(path.read_bytes())
        return fault


class MutatedMaps(unittest.TestCase):
    def test_made_maps_with_mistakes_compile_or_are_one_error_line(self):
        for number in range(0, 2 * TEST_COUNT, 2):
            with self.subTest(number=number):
                self.assertIsNone(fault_of_number(number, with_real=False))


def run_by_hand(options):
    if options.keep:
        Path(options.keep).mkdir(parents=True, exist_ok=True)
    faults = 0
    for number in range(options.first, options.first + options.count):
        if fault := fault_of_number(number, True, options.keep):
            faults += 1
            print(f"{number}: {fault}", flush=True)
        if (number + 1) % 100 == 0:
            print(f"{number + 1 - options.first} of {options.count} maps, {faults} faults", flush=True)
    print(f"{options.count} maps, {faults} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--count", type=int)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--keep")
    chosen = parser.parse_args()
    if chosen.count:
        sys.exit(run_by_hand(chosen))
    unittest.main()
