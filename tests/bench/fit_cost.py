#!/usr/bin/env python3
"""Fits the model of compiler/commands/plan/expected_cost.cpp to runs that measure_cost.py measured. By hand:

    tests/bench/fit_cost.py FITTED.jsonl… [--check HELD_OUT.jsonl…]

Prints the tables of the model and, with --check, its errors on places that it was not fitted to. Coefficients are the least squares of
relative errors, none negative: 1 % of a small region counts as 1 % of a large one. An error is relative to the geometric mean of what was
expected and what was measured, so that half and twice count alike.
"""
import argparse
import json
import math
import statistics

LEVELS = ("0.1", "0.5", "1.2", "2.5", "12.5")
FACTS = 10  # of own()
SAFETY = 2  # what a task on a cluster may take beside what is expected (task_lists.cpp)
OTHER_LEVELS = 0.5  # the share of their memory that levels other than the largest add

# Weights that are not fitted, since few measured regions have many of either: of a thousand way nodes (the whole of Porto, 350,000 nodes,
# took 0.57 GB) and of a thousand vertices of the heights (their size in memory, and what resampling took).
WAY_NODES_MB, VERTICES_MB, VERTICES_S = 1.2, 0.04, 0.0002


def own(run, share=1, share_of_plants=1):
    """A share of the facts of the region itself, and one of its plants: thousands of nodes of buildings, roads and other ways, of nodes with tags, of trees and of
    plantings; km²; tiles; whether there are trees and buildings, whose materials and prototypes take as much for few as for many: from 0 to 1."""
    ways, buildings, roads, nodes = (share * run[f"own_{name}"] / 1000 for name in ("way_nodes", "building_nodes", "road_nodes", "nodes"))
    trees, plantings = (share_of_plants * run[f"own_{name}"] / 1000 for name in ("trees", "plantings"))
    return [buildings, roads, ways - buildings - roads, nodes, trees, plantings, share * run["tiles"] * (run["tile_m"] / 1000) ** 2,
            share * run["tiles"], 1 - math.exp(-trees / 0.05), 1 - math.exp(-buildings / 0.2)]


def levels_of(run):
    return run["levels"].split(",")


def by_level(shares, row):
    """The row times the share of each level."""
    return [shares.get(level, 0) * x for level in LEVELS for x in row]


def measured_s(run):
    return run["plan_s"] + run["bake_s"]


def time_row(run):
    return [1, run["way_nodes"] / 1000] + own(run)


def memory_row(run):
    """The finest level and the fullest tile decide, because tiles are baked one after the other; of the other levels half is there too. The
    fullest of n tiles counts as n**0.5 mean ones, but woods fill tiles evenly."""
    finest, *others = levels_of(run)
    return [1] + by_level({finest: 1, **dict.fromkeys(others, OTHER_LEVELS)}, own(run, run["tiles"] ** -0.5, 1 / run["tiles"]))


def fixed_memory(run):
    return WAY_NODES_MB * 1e3 * run["way_nodes"] + VERTICES_MB * 1e3 * run["terrain_vertices"]


def bytes_row(run):
    return by_level(dict.fromkeys(levels_of(run), 1), own(run))


def total(coefficients, row):
    return sum(c * x for c, x in zip(coefficients, row))


def least_squares(rows, targets, rounds=300):
    """Coefficients that are not negative, by cyclic coordinate descent."""
    size = len(rows[0])
    gram = [[sum(row[i] * row[j] for row in rows) for j in range(size)] for i in range(size)]
    right = [sum(row[i] * target for row, target in zip(rows, targets)) for i in range(size)]
    found = [0.0] * size
    for _ in range(rounds):
        for i in range(size):
            if gram[i][i] > 0:
                rest = right[i] - sum(gram[i][j] * found[j] for j in range(size) if j != i)
                found[i] = max(0.0, rest / gram[i][i])
    return found


def fit(rows, fixed, values, rounds=8):
    """Coefficients such that rows times coefficients, and fixed, give the values."""
    scales = values
    for _ in range(rounds):
        found = least_squares([[x / scale for x in row] for row, scale in zip(rows, scales)],
                              [(value - part) / scale for value, part, scale in zip(values, fixed, scales)])
        expected = [max(1e-6, total(found, row) + part) for row, part in zip(rows, fixed)]
        scales = [(a * b) ** 0.5 for a, b in zip(expected, values)]
    return found


def time_shares(runs):
    """The time of a run of one level relative to one of all levels: the median of regions that were compiled both ways."""
    key = lambda run: (run["place"], run["region"], run["region_m"], run["tile_m"])
    whole = {key(run): measured_s(run) for run in runs if len(levels_of(run)) == len(LEVELS)}
    return {level: statistics.median(measured_s(run) / whole[key(run)] for run in runs if run["levels"] == level and key(run) in whole)
            for level in LEVELS}


class Model:
    def __init__(self, runs):
        alone = time_shares(runs)
        # what all levels share, such as grading the terrain, is in the share of each run of one level
        self.shared = (sum(alone.values()) - 1) / (len(LEVELS) - 1)
        self.shares = {level: share - self.shared for level, share in alone.items()}
        self.time = fit([time_row(run) for run in runs], [0] * len(runs), [measured_s(run) / self.share_of(run) for run in runs])
        self.memory = fit([memory_row(run) for run in runs], [fixed_memory(run) for run in runs], [run["memory_bytes"] for run in runs])
        self.bytes = fit([bytes_row(run) for run in runs], [0] * len(runs), [run["output_bytes"] for run in runs])

    def share_of(self, run):
        return self.shared + sum(self.shares[level] for level in levels_of(run))

    def errors(self, run):
        """The relative errors of time, memory and bytes."""
        return (total(self.time, time_row(run)) * self.share_of(run) / measured_s(run) - 1,
                (total(self.memory, memory_row(run)) + fixed_memory(run)) / run["memory_bytes"] - 1,
                total(self.bytes, bytes_row(run)) / run["output_bytes"] - 1)


def print_table(model):
    """Prints the model's constants as C++."""
    braces = lambda values: "{" + ", ".join(f"{value:.3g}" if value > 1e-4 else "0" for value in values) + "}"
    megabytes = lambda values: braces(value / 1e6 for value in values)
    print(f"kAround_s = {braces([*model.time[:2], VERTICES_S])}, kAround_mb = {braces([model.memory[0] / 1e6, WAY_NODES_MB, VERTICES_MB])};")
    print(f"kOwn_s = {braces(model.time[2:])};")
    print(f"kSharedTime = {model.shared:.3f};")
    for i, level in enumerate(LEVELS):
        print(f"{{{level}, {model.shares[level]:.3f}, {megabytes(model.memory[1 + FACTS * i:][:FACTS])}, {megabytes(model.bytes[FACTS * i:][:FACTS])}}},")


def print_errors(name, model, runs):
    over = sum(memory < 1 / SAFETY - 1 for _, memory, _ in map(model.errors, runs))
    medians = [statistics.median(map(abs, column)) for column in zip(*map(model.errors, runs))]
    print(f"{name}: {len(runs)} runs, {sum(map(measured_s, runs)):.0f} s; median errors "
          "time {:.0%}, memory {:.0%}, bytes {:.0%}; ".format(*medians) + f"{over} took more than {SAFETY} times the expected memory")


def read(paths):
    return [json.loads(line) for path in paths for line in open(path, encoding="utf-8")]


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("fitted", nargs="+")
    arguments.add_argument("--check", nargs="*", default=[])
    request = arguments.parse_args()
    runs = read(request.fitted)
    # a region that was drawn twice counts once
    held_out = list({(run["place"], run["region"], run["region_m"], run["tile_m"]): run for run in read(request.check)}.values())
    model = Model(runs)
    print_table(model)
    print_errors("fitted", model, runs)
    for place in sorted({run["place"] for run in runs}):
        print_errors("  " + place, model, [run for run in runs if run["place"] == place])
    if held_out:
        print_errors("held out", model, held_out)
        for run in held_out:
            print(f"  {run['place']} {run['region']} of {run['region_m']} m: {measured_s(run):.1f} s, "
                  "errors {:+.0%} {:+.0%} {:+.0%}".format(*model.errors(run)))


if __name__ == "__main__":
    main()
