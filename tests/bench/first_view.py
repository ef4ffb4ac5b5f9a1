#!/usr/bin/env python3
"""first_view.py RUN_OR_MANIFEST... : from `view` of a manifest to the first full picture in headless Chromium: seconds, requests, MB.
Alone on the machine; tests/interop needs `npm ci` once. Figures are in exporters/page/README.md."""
import json
import re
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
PROGRAM = ROOT / "build" / "release" / "citykiln"


def first_view(path, picture):
    """Seconds until the server listens, and the line of first_view.mjs."""
    started = time.monotonic()
    with subprocess.Popen([PROGRAM, "view", path, "--port", "0"], stdout=subprocess.PIPE, text=True) as server:
        url = re.search(r"http://\S+/", server.stdout.readline())[0]
        listens_s = time.monotonic() - started
        script = ROOT / "tests" / "interop" / "page" / "first_view.mjs"
        done = subprocess.run(["node", script, url, "0", picture], capture_output=True, text=True, check=True)
        server.terminate()
    return listens_s, json.loads(done.stdout)


def main():
    for number, path in enumerate(sys.argv[1:]):
        listens_s, seen = first_view(path, f"/tmp/first_view_{number}.png")
        print(f"{path}: listens after {listens_s:.2f} s; first tile {seen['first_tile_s']:.2f} s, full picture {seen['whole_s']:.2f} s after the "
              f"page is asked for; {seen['requests']} requests, {seen['mb']:.2f} MB; slowest {seen['slowest']}")


if __name__ == "__main__":
    main()
