#!/usr/bin/env python3
"""Fits the model of compiler/commands/expected_cost.cpp to runs that measure_cost.py measured. By hand:

    tests/bench/fit_cost.py FITTED.jsonl… [--check HELD_OUT.jsonl…]

Prints the tables of the model and, with --check, its errors on places that it was not fitted to. Coefficients are the least squares of
relative errors, none negative: 1 % of a small region counts as 1 % of a large one.
"""
import argparse
import json
import statistics

LEVELS = ("0.1", "0.5", "1.2", "2.5", "12.5")


def own(run):
    """Facts of the region itself: thousands of nodes of buildings, roads and other ways, of nodes with tags; km²; tiles."""
    ways, buildings, roads = (run[name] / 1000 for name in ("own_way_nodes", "own_building_nodes", "own_road_nodes"))
    return [buildings, roads, ways - buildings - roads, run["own_nodes"] / 1000, run["tiles"] * (run["tile_m"] / 1000) ** 2, run["tiles"]]


def around(run):
    """Facts of the region with its halo. Vertices of the heights have weights of their own, since few measured regions have many."""
    return [1, run["way_nodes"] / 1000]


# of a thousand vertices: their size in memory, and what resampling took
VERTICES_MB, VERTICES_S = 0.04, 0.0002


def by_level(run, row):
    """The row once for each level that the run has, zeros for the others."""
    levels = run["levels"].split(",")
    return [x if level in levels else 0 for level in LEVELS for x in row]


def time_row(run):
    """What all levels share, such as grading the terrain, counts once."""
    return around(run) + own(run) + by_level(run, own(run))


def memory_row(run):
    """The finest level decides."""
    finest = {**run, "levels": run["levels"].split(",")[0]}
    return around(run) + by_level(finest, own(run))


def bytes_row(run):
    return by_level(run, own(run))


def fit(rows, values, rounds=2000):
    """Coefficients that are not negative, by cyclic coordinate descent."""
    rows = [[x / value for x in row] for row, value in zip(rows, values)]
    size = len(rows[0])
    gram = [[sum(row[i] * row[j] for row in rows) for j in range(size)] for i in range(size)]
    right = [sum(row[i] for row in rows) for i in range(size)]
    found = [0.0] * size
    for _ in range(rounds):
        for i in range(size):
            if gram[i][i] > 0:
                rest = right[i] - sum(gram[i][j] * found[j] for j in range(size) if j != i)
                found[i] = max(0.0, rest / gram[i][i])
    return found


def total(coefficients, row):
    return sum(c * x for c, x in zip(coefficients, row))


ROWS = {"time": (time_row, lambda run: run["plan_s"] + run["bake_s"]), "memory": (memory_row, lambda run: run["memory_bytes"]),
        "bytes": (bytes_row, lambda run: run["output_bytes"])}


def fit_model(runs):
    return {name: fit([row(run) for run in runs], [value(run) for run in runs]) for name, (row, value) in ROWS.items()}


def errors(model, runs):
    """Of each run the relative errors of time, memory and bytes."""
    return [[abs(total(model[name], row(run)) / value(run) - 1) for name, (row, value) in ROWS.items()] for run in runs]


def print_table(model):
    """As C++: the rows of kShared and kLevels."""
    braces = lambda values: "{" + ", ".join(f"{value:.3g}" if value > 1e-4 else "0" for value in values) + "}"
    units = {"time": 1, "memory": 1e6, "bytes": 1e6}
    scaled = {name: [value / units[name] for value in coefficients] for name, coefficients in model.items()}
    print("around, time:", braces([*scaled["time"][:2], VERTICES_S]), "own:", braces(scaled["time"][2:8]), "around, memory:",
          braces([*scaled["memory"][:2], VERTICES_MB]))
    for i, level in enumerate(LEVELS):
        rows = [scaled[name][shared + 6 * i:shared + 6 * i + 6] for name, shared in (("time", 8), ("memory", 2), ("bytes", 0))]
        print(f"{{{level}, {braces(rows[0])}, {braces(rows[1])}, {braces(rows[2])}}},")


def print_errors(name, model, runs):
    medians = [statistics.median(column) for column in zip(*errors(model, runs))]
    print(f"{name}: {len(runs)} runs, {sum(run['plan_s'] + run['bake_s'] for run in runs):.0f} s; median errors "
          "time {:.0%}, memory {:.0%}, bytes {:.0%}".format(*medians))


def read(paths):
    return [json.loads(line) for path in paths for line in open(path, encoding="utf-8")]


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("fitted", nargs="+")
    arguments.add_argument("--check", nargs="*", default=[])
    request = arguments.parse_args()
    runs, held_out = read(request.fitted), read(request.check)
    model = fit_model(runs)
    print_table(model)
    print_errors("fitted", model, runs)
    for place in sorted({run["place"] for run in runs}):
        print_errors("  " + place, model, [run for run in runs if run["place"] == place])
    if held_out:
        print_errors("held out", model, held_out)
        for run, error in zip(held_out, errors(model, held_out)):
            print(f"  {run['place']} {run['region']} of {run['region_m']} m: {run['plan_s'] + run['bake_s']:.1f} s, "
                  "errors {:.0%} {:.0%} {:.0%}".format(*error))


if __name__ == "__main__":
    main()
