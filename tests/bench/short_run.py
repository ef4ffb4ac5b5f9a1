#!/usr/bin/env python3
"""short_run.py [TURN]: runs each benchmark for a few milliseconds and fails where one does not run or gives no positive, finite figure.
Times depend on the machine and are not compared. With TURN it runs an eighth of them, another one for each TURN. A benchmark
whose real data are absent is left out, and so is that of another program.
"""
import json
import math
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
PROGRAM = ROOT / "build/release/tests/citykiln_bench"
# messages of benchmarks without their data, or without the program of others that they time
ABSENT = ("missing: ", "osmium fileinfo failed")


def names(turn):
    listed = subprocess.run([PROGRAM, "--benchmark_list_tests"], capture_output=True, text=True, check=True).stdout.split("\n")
    every = sorted(line for line in listed if line)
    return every if turn is None else every[turn % 8::8]


def results(chosen):
    pattern = "^(" + "|".join(map(re.escape, chosen)) + ")$"
    done = subprocess.run([PROGRAM, f"--benchmark_filter={pattern}", "--benchmark_min_time=0.001", "--benchmark_format=json"],
                          capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"citykiln_bench ended with {done.returncode}\n{done.stderr}")
    return json.loads(done.stdout)["benchmarks"]


def fault_of(result):
    """Empty for a sound result."""
    if result.get("error_occurred"):
        return "" if result["error_message"].startswith(ABSENT) else result["error_message"]
    figures = {key: result[key] for key in ("iterations", "real_time", "cpu_time")}
    figures |= {key: value for key, value in result.items() if key.endswith("_per_second")}
    wrong = {key: value for key, value in figures.items() if not (math.isfinite(value) and value > 0)}
    return f"expected positive figures, found {wrong}" if wrong else ""


def main():
    chosen = names(int(sys.argv[1]) if len(sys.argv) > 1 else None)
    found = results(chosen)
    faults = [f"{result['name']}: {fault}" for result in found if (fault := fault_of(result))]
    if len(found) != len(chosen):
        faults.append(f"{len(chosen)} benchmarks were to run, {len(found)} did")
    if faults:
        sys.exit("\n".join(faults))
    print(f"{len(found)} benchmarks run")


if __name__ == "__main__":
    main()
