#!/usr/bin/env python3
"""Draws all things of grammars/things at some tolerances: one .glb and one picture for every dozen of similar size.

make_things.py BUILD OUT [--tolerances 0,0.05,0.3] [--columns 12] [--no-pictures] [NAME …]
Prints the triangles of each thing at each tolerance. BUILD holds citykiln and tests/rule_glb.
"""
import argparse
import re
import subprocess
from pathlib import Path

THINGS = Path(__file__).resolve().parent.parent / "things"
# attributes that show more of a rule than its defaults
SHOWN = {"speed_sign": "text=50", "full_turnstile": "kind=turnstile", "traffic_sign": "kind=warning", "fire_hydrant": "country=central_europe"}


def table():
    """Name, rule and size of the rows of things.txt, or of rows.txt where there is no such table."""
    if (THINGS / "things.txt").exists():
        for line in (THINGS / "things.txt").read_text().splitlines():
            cells = line.split("#")[0].split()
            if len(cells) >= 4:
                yield cells[0], cells[2], cells[3]
        return
    for line in (THINGS / "rows.txt").read_text().splitlines():
        cells = [cell.strip() for cell in line.split("|")]
        if not line.startswith("#") and len(cells) >= 8:
            yield cells[0], cells[2], cells[3]


def rows(wanted):
    """Name, rule and size in metres of each thing, the lowest first."""
    found = []
    for name, rule, size in table():
        if not wanted or name in wanted:
            # height:0.9 is 0.9 m where no tag says otherwise
            found.append((name, rule, [float(m) for m in re.findall(r"[0-9.]+", size)]))
    return sorted(found, key=lambda row: max(row[2][0], row[2][2]))


def order_of(name, rule, size, x):
    width, depth, height = size
    words = f"{THINGS}/{rule}.cga thing=1 x={x:.2f} w={width} d={depth} h={height} {SHOWN.get(name, '')}"
    return words.strip()


def draw(build, out, number, group, tolerance, picture):
    x, orders = 0.0, []
    gap = 0.35 * max(max(size[0], size[2]) for _, _, size in group)
    for name, rule, size in group:
        orders.append(order_of(name, rule, size, x))
        x += max(size[0], 0.3 * size[2]) + gap
    wide, high = x - gap, max(size[2] for _, _, size in group)
    glb = out / f"things_{number:02}_{tolerance:g}.glb"
    printed = subprocess.run([build / "tests/rule_glb", glb, str(tolerance), *orders], check=True, capture_output=True, text=True).stdout
    if picture:
        far = max(wide * 0.9, 3.2 * high)
        subprocess.run([build / "citykiln", "preview", glb, "--eye", f"{0.42 * wide},{-far},{0.35 * far}", "--look", f"{wide / 2},0,{0.42 * high}", "--fov", "58",
                        "--size", "1600x560", "--spp", "12", "--time", "2024-06-10T11:00:00Z", "--quiet", "-o", glb.with_suffix(".png")], check=True)
    return [int(n) for n in re.findall(r"(\d+) triangles", printed)]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("build", type=Path)
    parser.add_argument("out", type=Path)
    parser.add_argument("--tolerances", default="0,0.05,0.3")
    parser.add_argument("--columns", type=int, default=12)
    parser.add_argument("--no-pictures", action="store_true")
    parser.add_argument("names", nargs="*")
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    things, counts = rows(options.names), {}
    for tolerance in map(float, options.tolerances.split(",")):
        for at in range(0, len(things), options.columns):
            group = things[at:at + options.columns]
            triangles = draw(options.build, options.out, at // options.columns, group, tolerance, not options.no_pictures)
            for (name, _, _), count in zip(group, triangles):
                counts.setdefault(name, []).append(count)
    for name, triangles in counts.items():
        print(f"{name:22}", *(f"{count:6}" for count in triangles))


if __name__ == "__main__":
    main()
