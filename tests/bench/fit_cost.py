#!/usr/bin/env python3
"""Fits the model of compiler/commands/expected_cost.cpp to runs that measure_cost.py measured. By hand:

    tests/bench/fit_cost.py FITTED.jsonl… [--check HELD_OUT.jsonl…]

Prints the table of the model and, with --check, its errors on places that it was not fitted to. Coefficients are the least squares of
relative errors, none negative: 1 % of a small region counts as 1 % of a large one.
"""
import argparse
import json
import statistics

LEVELS = ("0.1", "0.5", "1.2", "2.5", "12.5")


def facts(run):
    """What plan knows of a region: of its own, 1, thousands of nodes of buildings, roads and others, km², tiles."""
    own, buildings, roads = (run[name] / 1000 for name in ("own_way_nodes", "own_building_nodes", "own_road_nodes"))
    return [1, buildings, roads, own - buildings - roads, run["tiles"] * (run["tile_m"] / 1000) ** 2, run["tiles"]]


def around(run):
    return [1, run["way_nodes"] / 1000, run["terrain_vertices"] / 1000]


def fit(rows, values, rounds=4000):
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


class Model:
    def __init__(self, runs):
        self.plan_s = fit([around(run) for run in runs], [run["plan_s"] for run in runs])
        of_level = {level: [run for run in runs if run["levels"] == level] for level in LEVELS}
        by = lambda value: {level: fit([facts(run) for run in some], [run[value] for run in some]) for level, some in of_level.items()}
        self.bake_s, self.bytes = by("bake_s"), by("output_bytes")
        self.memory = {level: fit([around(run) + facts(run)[1:5] for run in some], [run["memory_bytes"] for run in some])
                       for level, some in of_level.items()}

    def seconds_of(self, run):
        return total(self.plan_s, around(run)) + sum(total(self.bake_s[level], facts(run)) for level in run["levels"].split(","))

    def memory_of(self, run):
        return max(total(self.memory[level], around(run) + facts(run)[1:5]) for level in run["levels"].split(","))

    def bytes_of(self, run):
        return sum(total(self.bytes[level], facts(run)) for level in run["levels"].split(","))


def errors(model, runs):
    """Of each run the relative errors of seconds, memory and bytes."""
    return [(abs(model.seconds_of(run) / (run["plan_s"] + run["bake_s"]) - 1), abs(model.memory_of(run) / run["memory_bytes"] - 1),
             abs(model.bytes_of(run) / run["output_bytes"] - 1)) for run in runs]


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
    model = Model(runs)
    print("plan, s:", *(f"{value:.4g}" for value in model.plan_s))
    for name, table in (("bake, s", model.bake_s), ("bytes", model.bytes), ("memory", model.memory)):
        for level, row in table.items():
            print(f"{name}, {level} m:", *(f"{value:.4g}" for value in row))
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
