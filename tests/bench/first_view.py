#!/usr/bin/env python3
"""first_view.py RUN_OR_MANIFEST... : from `view` of a manifest to the first full picture in headless Chromium, and from there to a
walk in a street: seconds, requests, MB, draw calls, triangles. Alone on the machine; tests/interop needs `npm ci` once. The environment variable
CITYKILN names the program. Figures are in exporters/page/README.md."""
import json
import os
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
PROGRAM = os.environ.get("CITYKILN", ROOT / "build" / "release" / "citykiln")


def first_view(path, picture):
    """Returns the costs of both views, as first_view.mjs prints them."""
    with subprocess.Popen([PROGRAM, "view", path, "--port", "0"], stdout=subprocess.PIPE, text=True) as server:
        url = re.search(r"http://\S+/", server.stdout.readline())[0]
        script = ROOT / "tests" / "interop" / "page" / "first_view.mjs"
        done = subprocess.run(["node", script, url, picture], capture_output=True, text=True, check=True)
        server.terminate()
    return json.loads(done.stdout)


def row_of(name, view):
    """A row of the table."""
    first_tile = f"{view['first_tile_s']:.1f}" if "first_tile_s" in view else ""
    return f"| {name} | {first_tile} | {view['whole_s']:.1f} | {view['requests']} | {view['mb']:.1f} | {view['calls']} | {view['triangles']:,} |"


def main():
    print("| view | first tile, s | full picture, s | requests | MB | draw calls | triangles |\n|---|---|---|---|---|---|---|", flush=True)
    for number, path in enumerate(sys.argv[1:]):
        seen = first_view(path, f"/tmp/first_view_{number}")
        print(row_of(f"{path}, first view", seen["first"]))
        print(row_of(f"{path}, {seen['street']['street']}, on foot", seen["street"]), flush=True)


if __name__ == "__main__":
    main()
