#!/usr/bin/env python3
"""works.py [N...]: redoes studies of five works that citykiln grew from, and writes each into its section of tests/charts/works.md.

Without numbers it runs all studies that this file has; the others of the page are charts of citykiln-chart, or say why they cannot be redone.
Alone on the machine; all take about an hour on two cores. CPU seconds are user and system time of all threads, memory is the largest resident
set, both of the whole process. Real maps are read from ../shared/data.
"""
import json
import math
import os
import re
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "properties"))
import png  # noqa: E402

PAGE = ROOT / "tests" / "charts" / "works.md"
DATA = ROOT.parent / "shared" / "data"
PROGRAM = os.environ.get("CITYKILN", ROOT / "build" / "release" / "citykiln")
SMALL = ["--size", "320x180", "--no-denoise"]
STUDIES = {}


@dataclass
class Measured:
    wall_s: float
    cpu_s: float
    memory_mb: float
    output: str


def measured(*words, program=PROGRAM):
    """Runs a program, and measures it."""
    begun = time.monotonic()
    with tempfile.TemporaryFile("w+") as output:
        process = subprocess.Popen([program, *map(str, words)], stdout=output, stderr=subprocess.STDOUT)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        output.seek(0)
        text = output.read()
    if process.returncode != 0:
        sys.exit(f"{program} {' '.join(map(str, words))}: {text[-600:]}")
    return Measured(time.monotonic() - begun, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1000, text)


def report_of(out):
    return json.loads(Path(out, "report.json").read_text())


def megabytes(*patterns):
    return sum(path.stat().st_size for pattern in patterns for path in Path().glob(pattern)) / 1e6


def table(head, rows):
    """A Markdown table; numbers are right-aligned."""
    def shown(cell):
        if isinstance(cell, float):
            return f"{cell:.2g}" if abs(cell) < 10 else f"{cell:,.0f}"
        return f"{cell:,}" if isinstance(cell, int) else str(cell)
    first = rows[0]
    line = "|".join("--:" if isinstance(cell, (int, float)) else "---" for cell in first)
    return "\n".join([f"| {' | '.join(head)} |", f"|{line}|", *(f"| {' | '.join(map(shown, row))} |" for row in rows)])


def study(number):
    """Registers a function that returns the Markdown of a section of the page."""
    def register(function):
        STUDIES[number] = function
        return function
    return register


# ---- 000 Temnyakov: forms of a scene ----

SCENES = {
    "Zličín, 49 buildings, 117 roads, 227 lamps": ("village of Baden-Württemberg", ["small/regglisweiler-10.068_48.135.osm"]),
    "Belgrade, 570, 373, 420": ("Monaco's rock and harbour", ["monaco/cut-1km2-monacoville-port.osm"]),
    "New York, 778, 316, 514": ("West Village, all of it", ["nyc/nyc-west-village.osm.pbf"]),
    "Berlin, 672, 457, 1,406": ("Berlin, Gesundbrunnen", ["berlin/berlin-mitte-gesundbrunnen.osm"]),
    "Krasnoyarsk, 1,384, 1,981, 4,869": ("Andorra la Vella", ["andorra/cut-andorra-la-vella.osm.pbf", "--dem", "andorra/N42E001.hgt"]),
}
FORM = ["--tile", "256", "--lods", "0.25", "--surroundings", "none", "--emit", "kiln,glb"]


def map_words(words):
    return [word if word.startswith("--") else DATA / word for word in words]


def compiled(name, words, *more):
    """A run of a scene, compiled once, and its CPU seconds."""
    done = measured("compile", *map_words(words), *FORM, *more, "-o", name)
    return report_of(name), done


def started(path, *words):
    """The first picture of a scene, with one path a pixel."""
    return measured("preview", path, *words, *SMALL, "--spp", "1", "--view", "street", "-o", "first.png")


@study(1)
def five_scenes():
    rows = []
    for theirs, (ours, words) in SCENES.items():
        report, done = compiled("scene", words)
        counts = report["counts"]
        recipe, stored = megabytes("scene/scene.kiln"), megabytes("scene/glb/**/*")
        a, b = started("scene/scene.kiln"), started("scene", "--level", "0")
        rows.append([theirs.split(",")[0], ours, counts["buildings"], counts["roads"], counts["lamps"], recipe, stored, stored / recipe, done.cpu_s, a.cpu_s, b.cpu_s])
    return table(["theirs", "ours", "buildings", "roads", "lamps", "recipes (MB)", "stored (MB)", "ratio", "compile", "recipes (CPU s)", "stored"], rows)


def of_height(height):
    path = Path(f"{height}.edits")
    path.write_text(f"building set height={height} remove building:levels building:min_level min_height roof:height\n")
    return ["--edits", path]


@study(2)
def heights():
    rows = []
    for height in (20, 40, 80, 180):
        report, _ = compiled("high", SCENES["New York, 778, 316, 514"][1], *of_height(height))
        a, b = started("high/scene.kiln"), started("high", "--level", "0")
        triangles = sum(level["triangles"] for level in report["levels"])
        rows.append([height, triangles, megabytes("high/scene.kiln"), megabytes("high/glb/**/*"), a.memory_mb, b.memory_mb, a.cpu_s, b.cpu_s])
    return table(["mean height (m)", "triangles", "recipes (MB)", "stored (MB)", "recipes", "stored",
                  "recipes (CPU s)", "stored"], rows)


@study(3)
def new_york_180():
    words = SCENES["New York, 778, 316, 514"][1]
    compiled("high", words, *of_height(180))
    rows = []
    for budget in ("64MB", "256MB", "1GB", "2GB"):
        done = measured("preview", "high/scene.kiln", *SMALL, "--spp", "4", "--view", "overview", "--memory-budget", budget, "-o", "a.png")
        rows.append([f"recipes, budget {budget}", done.memory_mb, done.cpu_s])
    done = measured("preview", "high", "--level", "0", *SMALL, "--spp", "4", "--view", "overview", "-o", "b.png")
    return table(["form", "memory (MB)", "CPU s"], [*rows, ["stored", done.memory_mb, done.cpu_s]])


def fitted(points):
    """Slope, intercept and correlation of a line through points."""
    n, sx, sy = len(points), sum(x for x, _ in points), sum(y for _, y in points)
    mx, my = sx / n, sy / n
    xx, yy = sum((x - mx)**2 for x, _ in points), sum((y - my)**2 for _, y in points)
    xy = sum((x - mx) * (y - my) for x, y in points)
    return xy / xx, my - xy / xx * mx, xy / math.sqrt(xx * yy)


@study(4)
def memory_over_buildings():
    points = {"recipes": [], "stored": []}
    for _, words in SCENES.values():
        report, _ = compiled("scene", words)
        for form, path in (("recipes", ["scene/scene.kiln"]), ("stored", ["scene", "--level", "0"])):
            done = measured("preview", *path, *SMALL, "--spp", "1", "--view", "overview", "-o", "first.png")
            points[form].append((report["counts"]["buildings"], done.memory_mb))
    rows = []
    for form, each in points.items():
        slope, start, correlation = fitted(each)
        rows.append([form, ", ".join(f"{y:.0f}" for _, y in each), slope * 1000, start, correlation])
    return table(["form", f"memory (MB) at {', '.join(str(x) for x, _ in points['stored'])} buildings", "kB a building", "MB without", "correlation"], rows)


@study(5)
def frames_of_both_forms():
    rows = []
    for height in (20, 40, 80):
        compiled("high", SCENES["Berlin, 672, 457, 1,406"][1], *of_height(height))
        for view in ("street", "overview", "top"):
            a, b = [measured("preview", *path, *SMALL, "--spp", "4", "--view", view, "-o", "f.png") for path in (["high/scene.kiln"], ["high", "--level", "0"])]
            rows.append([height, view, a.cpu_s, b.cpu_s, a.cpu_s / b.cpu_s])
    return table(["mean height (m)", "view", "from recipes (CPU s)", "stored (CPU s)", "ratio"], rows)


# ---- 000 Temnyakov: light ----

NIGHT = ["--time", "2026-12-21T17:30:00Z"]


@study(6)
def lit_windows():
    rows = []
    for name in ("Berlin, 672, 457, 1,406", "New York, 778, 316, 514"):
        compiled("scene", SCENES[name][1])
        first = None
        for share in ("0", "0.25", "0.5", "1"):
            done = measured("preview", "scene/scene.kiln", *SMALL, "--spp", "16", "--view", "street", *NIGHT, "--lit-windows", share, "-o", "n.png")
            first = first or done
            rows.append([SCENES[name][0], f"{float(share):.0%}", done.cpu_s, f"{done.cpu_s / first.cpu_s - 1:+.0%}", done.memory_mb])
    return table(["scene", "windows lit", "CPU s", "against none", "memory (MB)"], rows)


@study(7)
def markings():
    rows = []
    plain = Path("plain.edits")
    plain.write_text("highway set lane_markings=no\nhighway=crossing set crossing:markings=no\n")
    for name in ("Berlin, 672, 457, 1,406", "Belgrade, 570, 373, 420", "Krasnoyarsk, 1,384, 1,981, 4,869"):
        row = [SCENES[name][0]]
        for more in ([], ["--edits", plain]):
            compiled("scene", SCENES[name][1], *more)
            row.append(measured("preview", "scene/scene.kiln", *SMALL, "--spp", "32", "--view", "street", "-o", "m.png").cpu_s)
        rows.append([*row, f"{row[1] / row[2] - 1:+.0%}"])
    return table(["scene", "with markings (CPU s)", "plain (CPU s)", "markings cost"], rows)


def lamps_of(words):
    """The number of street lamps, mapped and assumed: each is a light of the files when all are asked for."""
    measured("compile", *map_words(words), "--tile", "256", "--lods", "12.5", "--surroundings", "none", "--lights", "100000", "--layout", "embedded",
             "--emit", "kiln,glb", "-o", "lamps")
    count = 0
    for path in Path("lamps/glb").glob("*.glb"):
        data = path.read_bytes()
        gltf = json.loads(data[20:20 + int.from_bytes(data[12:16], "little")])
        count += sum("KHR_lights_punctual" in node.get("extensions", {}) for node in gltf["nodes"])
    return count


@study(8)
def lamps():
    rows = []
    for name in ("Berlin, 672, 457, 1,406", "Krasnoyarsk, 1,384, 1,981, 4,869"):
        compiled("scene", SCENES[name][1])
        row = [measured("preview", "scene/scene.kiln", *SMALL, "--spp", "16", "--view", "street", *NIGHT, "--lamps", on, "-o", "l.png").cpu_s for on in ("off", "on")]
        rows.append([SCENES[name][0], lamps_of(SCENES[name][1]), *row, f"{row[1] / row[0] - 1:+.0%}"])
    return table(["scene", "lamps", "off (CPU s)", "on (CPU s)", "lamps cost"], rows)


def luminances(path):
    """The values of all channels of a PNG, 0 to 255."""
    return png.pixels(Path(path))[3]


def difference(a, b):
    """The root mean square difference of two pictures."""
    return math.sqrt(sum((x - y)**2 for x, y in zip(a, b)) / len(a))


@study(9)
def samples():
    compiled("scene", SCENES["Berlin, 672, 457, 1,406"][1])
    exposure = ["--exposure", "+0"]
    def drawn(spp, name):
        return measured("preview", "scene/scene.kiln", *SMALL, "--spp", spp, "--view", "street", *exposure, "-o", name)
    drawn(256, "reference.png")
    reference = luminances("reference.png")
    rows = []
    for spp in (1, 5, 10, 64):
        done = drawn(spp, "s.png")
        rows.append([spp, done.cpu_s, difference(luminances("s.png"), reference)])
    slope, start, correlation = fitted([(row[0], row[1]) for row in rows])
    return (table(["samples", "CPU s", "RMS difference from 256 samples (of 255)"], rows) +
            f"\n\nTime is {start:.1f} + {slope:.3f} a sample (CPU s; correlation {correlation:.4f}).")


@study(10)
def roulette():
    compiled("scene", SCENES["Berlin, 672, 457, 1,406"][1])
    common = ["preview", "scene/scene.kiln", "--size", "160x90", "--no-denoise", "--view", "street", *NIGHT, "--exposure", "+0"]
    measured(*common, "--spp", "256", "--bounces", "30", "--roulette", "0", "-o", "reference.png")
    reference = luminances("reference.png")
    rows = []
    for bounces in (3, 10, 30):
        for share in ("0", "0.01", "0.5", "0.99"):
            done = measured(*common, "--spp", "16", "--bounces", bounces, "--roulette", share, "-o", "r.png")
            rows.append([bounces, share, done.cpu_s, difference(luminances("r.png"), reference)])
    return table(["bounces", "paths end below", "CPU s", "RMS difference from 30 bounces (of 255)"], rows)


# ---- 001: a ray tracer's effects, tile cities ----

@study(13)
def effects():
    compiled("scene", SCENES["Berlin, 672, 457, 1,406"][1])
    common = ["preview", "scene/scene.kiln", *SMALL, "--spp", "32"]
    plain = measured(*common, "--view", "street", "-o", "e.png")
    night = measured(*common, "--view", "street", *NIGHT, "-o", "e.png")
    lens = measured(*common, "--view", "street", "--aperture", "f/1.4", "--focus", "12", "-o", "e.png")
    turn = measured(*common, "--view", "street", "--turntable", "1", "-o", "e##.png")
    moving = measured(*common, "--view", "street", "--turntable", "1", "--shutter", "0.02", "-o", "e##.png")
    rows = [["pinhole, by day", "chessboard 74 s", plain.cpu_s, 1.0], ["lens, f/1.4", "lens 27 s", lens.cpu_s, lens.cpu_s / plain.cpu_s],
            ["area lights: lamps, lit windows", "area light 49 s", night.cpu_s, night.cpu_s / plain.cpu_s],
            ["camera in motion", "dragon moving 27,925 s", moving.cpu_s, moving.cpu_s / turn.cpu_s]]
    return table(["ours", "theirs", "CPU s", "against without"], rows)


BLADES_A_TUFT = 46  # lsystems/species/grass.lsys


def drawn_by_three(folder, eye, look):
    """Returns what three.js draws of a run's tileset in headless Chromium, at an error of one pixel."""
    job = {"page": "fly_three.html", "folder": str(Path(folder, "3dtiles").resolve()), "size": [1280, 720], "error_px": 1,
           "views": [{"eye": eye, "look": look, "out": "three.png"}], "facts": "facts.json"}
    Path("job.json").write_text(json.dumps(job))
    subprocess.run(["node", ROOT / "tests/interop/fly_tiles3d.mjs", "job.json"], check=True)
    return json.loads(Path("facts.json").read_text())["views"][0]


@study(16)
def grass():
    Path("species").mkdir()
    Path("species/spawners.txt").write_text("landuse=grass grass 1 1 0.9 0.9..1.1\n")
    rows = []
    for blades in (10_000, 20_000, 40_000, 80_000):
        side_m = math.sqrt(blades / BLADES_A_TUFT)
        square_map(side_m, {"landuse": "grass"})
        made = measured("compile", "square.osm", "--species", "species", "--lods", "0.02", "--surroundings", "none", "--emit", "kiln,glb,3dtiles", "-o", "grass")
        tufts = sum(tile["instances"] for tile in report_of("grass")["tiles"])
        three = drawn_by_three("grass", [0, -side_m, side_m / 3], [0, 0, 0])
        traced = measured("preview", "grass/scene.kiln", *SMALL, "--spp", "16", "--eye", f"0,{-side_m:.1f},{side_m / 3:.1f}", "--look", "0,0,0", "-o", "g.png")
        rows.append([tufts * BLADES_A_TUFT, tufts, three["triangles"], three["calls"], three["bytes"] / 1e6, three["frame_ms"], made.cpu_s, traced.cpu_s])
    return table(["blades", "tufts", "triangles drawn", "draw calls", "MB loaded", "ms a frame", "compile (CPU s)", "traced (CPU s)"], rows)


@study(17)
def tile_cities():
    rows = []
    for cells in (25, 100):
        for fixed in (5, 25, 100, 400):
            share = fixed / cells**2
            Path("tiles.json").write_text(json.dumps({"kind": "tiles", "seed": 7, "size": cells * 40, "tiles": {"fixed": share}}))
            done = measured("invent", "--settings", "tiles.json", "-o", "tiles")
            side, made, contradictions, taken_back, parts = re.search(
                r"(\d+) x \d+ cells: (\d+) fixed by noise, (\d+) contradictions, (\d+) decisions taken back; road network: (\d+) parts", done.output).groups()
            rows.append([f"{side}²", int(made), f"{share:.1%}", int(contradictions), int(taken_back), int(parts), done.cpu_s])
    return table(["cells", "fixed by noise", "share", "contradictions", "decisions taken back", "parts of the network", "CPU s"], rows)


# ---- 002 Rudzki: RPForest ----

RPFOREST_CPU_S, RPFOREST_MB = 434, 1240


@study(18)
def default_picture():
    # the files of a spec are named from the project's folder
    Path("examples").symlink_to(ROOT / "examples")
    measured("compile", "--spec", "examples/glade/spec.json", "-o", "glade")
    rows = []
    for bounces in (3, 1):
        done = measured("preview", "glade", "--level", "0", "--eye-lonlat", "17.0284574,51.1112702,24.31", "--look-lonlat", "17.0284574,51.1113781,20.80",
                        "--size", "480x270", "--spp", "64", "--no-denoise", "--bounces", bounces, "-o", "glade.png")
        share = 480 * 270 * 64 / (1920 * 1080 * 256)
        rows.append([f"ours, {bounces} bounces", "480 × 270 × 64", done.cpu_s, done.cpu_s / share, done.cpu_s / share / RPFOREST_CPU_S, done.memory_mb])
    return table(["program", "picture", "CPU s", "CPU s for 1920 × 1080 × 256", "against RPForest", "memory (MB)"],
                 [*rows, ["RPForest, run by us", "1920 × 1080 × 256", RPFOREST_CPU_S, RPFOREST_CPU_S, 1.0, RPFOREST_MB]])


@study(19)
def other_spots():
    settings = json.loads((ROOT / "examples/forest/invent.json").read_text())
    rows = []
    for name, height, hour in (("default", 5, "2026-06-21T12:00Z"), ("mountain top", 60, "2026-06-21T12:00Z"), ("dead: without leaves", 5, "2026-01-21T12:00Z")):
        settings["spot"]["height"] = height
        Path("forest.json").write_text(json.dumps(settings))
        said = measured("invent", "--settings", "forest.json", "-o", "forest").output
        measured("compile", "--spec", "forest/spec.json", "--time", hour, "--lods", "0.1", "-o", "forest/run")
        camera = re.search(r"--eye (\S+) --look (\S+)", said)
        done = measured("preview", "forest/run/scene.kiln", "--eye", camera[1], "--look", camera[2], *SMALL, "--spp", "64", "-o", "f.png")
        rows.append([name, done.cpu_s, done.memory_mb])
    return table(["scene", "CPU s for 320 × 180 × 64", "memory (MB)"], rows)


def square_map(side_m, tags):
    """Writes square.osm: a square area at 48 degrees north."""
    north, east = side_m / 2 / 111_200, side_m / 2 / 74_500
    corners = [(48 - north, 11 - east), (48 - north, 11 + east), (48 + north, 11 + east), (48 + north, 11 - east)]
    nodes = "".join(f'<node id="{i + 1}" lat="{lat:.7f}" lon="{lon:.7f}"/>' for i, (lat, lon) in enumerate(corners))
    refs = "".join(f'<nd ref="{i}"/>' for i in (1, 2, 3, 4, 1))
    text = "".join(f'<tag k="{key}" v="{value}"/>' for key, value in tags.items())
    Path("square.osm").write_text(f'<osm version="0.6">{nodes}<way id="1">{refs}{text}</way></osm>')


@study(21)
def plants_before_it_breaks():
    rows = []
    for side_m in (50, 160, 500, 1600):
        square_map(side_m, {"natural": "wood", "leaf_type": "broadleaved"})
        made = measured("compile", "square.osm", "--lods", "2.5", "--surroundings", "none", "-o", "wood")
        plants = sum(tile["instances"] for tile in report_of("wood")["tiles"])
        drawn = measured("preview", "wood/scene.kiln", *SMALL, "--spp", "16", "--view", "overview", "-o", "w.png")
        rows.append([side_m, plants, made.cpu_s, made.memory_mb, megabytes("wood/scene.kiln") * 1000, megabytes("wood/glb/*"), drawn.cpu_s, drawn.memory_mb])
    return table(["side (m)", "plants", "compile (CPU s)", "MB", "manifest (kB)", "tiles (MB)", "picture (CPU s)", "MB"], rows)


# ---- 003 Bruneton: Rama; charts of citykiln-chart ----

CHART = ROOT / "build" / "release" / "citykiln-chart"


def series_of(name, *words):
    """The series of all charts of a kind, as {chart: {series: [(x, y)]}}, and the lines that the chart prints."""
    said = measured(name, *words, "-o", "charts", program=CHART).output
    charts = {}
    for path in sorted(Path("charts").glob("*.csv")):
        for line in path.read_text().splitlines()[1:]:
            label, x, y = line.rsplit(",", 2)
            charts.setdefault(path.stem, {}).setdefault(label.strip('"'), []).append((float(x), float(y)))
    return charts, said


def table_of_chart(name):
    """The table that a chart prints."""
    _, said = series_of(name)
    return "\n".join(line for line in said.splitlines() if line.startswith("|"))


@study(14)
def with_and_without_a_hierarchy():
    return table_of_chart("hierarchy")


@study(15)
def stratified_samples():
    return table_of_chart("sampling")


@study(30)
def ways_to_scatter():
    return table_of_chart("scatter")


@study(31)
def stability():
    return table_of_chart("stability")


@study(24)
def air():
    _, said = series_of("air")
    found = re.findall(r"^(.*): (\S+) at the ground; columns within (\S+)$", said, re.MULTILINE)
    return table(["air", "density at the ground over the axis", "largest relative error of columns"], [[name, ratio, float(error)] for name, ratio, error in found])


RAMA_EYE = ["--eye", "420,-260,130", "--look", "-700,900,60", "--fov", "70"]
RAMA_NIGHT = ["--time", "2026-06-21T23:30"]
RAMA_PAIRS = {
    "all": [],
    "clearest air, which sees 300 km": ["--visibility", "300"],
    "haze, which sees 2 km": ["--visibility", "2"],
    "light of the lines alone, none reflected": ["--bounces", "1"],
    "lines dark: lamps and windows": RAMA_NIGHT,
    "lines dark, windows alone": [*RAMA_NIGHT, "--lamps", "off"],
    "lines dark, lamps alone": [*RAMA_NIGHT, "--lit-windows", "none"],
    "lines dark, neither": [*RAMA_NIGHT, "--lamps", "off", "--lit-windows", "none"],
    "without buildings, and so without their shadows": ["--layers=-buildings"],
    "without plants": ["--layers=-plants"],
}


@study(25)
def with_and_without():
    map_words = ["python3", ROOT / "examples/rama/make_rama.py", "out/rama_map"]
    subprocess.run(map_words, check=True, stdout=subprocess.DEVNULL)
    measured("compile", "--spec", ROOT / "examples/rama/spec.json", "--emit", "kiln", "-o", "rama")
    # daylight's exposure by day, and one of dusk by night
    rows, whole = [], {}
    for name, words in RAMA_PAIRS.items():
        is_night = "--time" in words
        done = measured("preview", "rama/scene.kiln", "--tolerance", "12.5", *RAMA_EYE, *words, *SMALL, "--spp", "16", "--exposure", "+6" if is_night else "+0",
                        "-o", "r.png")
        values = luminances("r.png")
        base = whole.setdefault(is_night, values)
        rows.append([name, sum(values) / len(values), difference(values, base), done.cpu_s])
    return table(["picture", "mean (of 255)", "RMS difference from the first by day, or by night (of 255)", "CPU s"], rows)


@study(22)
def one_eye():
    charts, _ = series_of("view", "--map", DATA / "monaco/cut-1km2-monacoville-port.osm", "--dem", DATA / "monaco/N43E007.hgt")
    rows = [[series, x, int(y)] for each in charts.values() for series, points in each.items() for x, y in points]
    return table(["mesh", "error in the picture (pixels)", "triangles"], rows)


@study(23)
def line_lights():
    _, said = series_of("linelights")
    found = {}
    for name, count, error, us in re.findall(r"^(.*), (\d+) a line: error (\S+), (\S+) µs$", said, re.MULTILINE):
        found.setdefault((name, int(count)), []).extend((float(error), float(us)))
    rows = [[name, count, plain, us, walled] for (name, count), (plain, us, walled, _) in found.items()]
    closed = re.search(r"closed form: error (\S+) .*, (\S+) µs", said)
    rows.append(["closed form", "", float(closed[1]), float(closed[2]), ""])
    return table(["method", "samples a line", "RMS error over the mean", "µs a place and line", "RMS error behind a wall"], rows)


# ---- 004 Oplatek: terrain by maps ----

@study(26)
def threads():
    rows, first = [], None
    for count in (1, 2):
        done = measured("compile", DATA / "monaco/monaco-2023.osm.pbf", "--dem", DATA / "monaco/N43E007.hgt", "--lods", "0.5", "--threads", count, "-o", "monaco")
        first = first or done
        rows.append([count, done.wall_s, first.wall_s / done.wall_s, done.cpu_s, done.memory_mb])
    return table(["threads", "seconds", "times as fast", "CPU s", "memory (MB)"], rows)


@study(32)
def drawn_in_chromium():
    """The small place's woods, thinned and not, from 1.5 km, as three.js draws its tiles."""
    rows = []
    for density in ("0", "0.1", "1"):
        measured("compile", DATA / "andorra/andorra-2023.osm.pbf", "--dem", DATA / "andorra/N42E001.hgt", "--bbox", "1.600,42.558,1.618,42.5714", "--lods",
                 "0.5,2.5,12.5", "--wood-density", density, "--emit", "glb,3dtiles", "--surroundings", "none", "-o", "small")
        three = drawn_by_three("small", [0, -900, 2700], [0, 0, 1700])
        plants = [sum(tile["instances"] for tile in report_of("small")["tiles"] if tile["level"] == level) for level in (0, 1)]
        rows.append([density, *plants, three["triangles"], three["calls"], three["bytes"] / 1e6, three["frame_ms"]])
    return table(["density of woods, 2.2 km² of Canillo", "instances at 0.5 m", "at 2.5 m", "triangles drawn", "draw calls", "MB loaded", "ms a frame"], rows)


@study(27)
def plants_drawn():
    rows = []
    places = (("2.2 km² of Andorra la Vella", ["andorra/cut-andorra-la-vella.osm.pbf", "--dem", "andorra/N42E001.hgt"], ["--bbox", "1.515,42.500,1.533,42.5135"]),
              ("10 km² of Andorra la Vella", ["andorra/cut-andorra-la-vella.osm.pbf", "--dem", "andorra/N42E001.hgt"], []),
              ("160 km² of Liechtenstein", ["liechtenstein/liechtenstein-2015.osm.pbf"], []))
    for name, words, more in places:
        for density in ("1", "0.1"):
            done = measured("compile", *map_words(words), *more, "--lods", "2.5", "--wood-density", density, "--surroundings", "none", "-o", "land")
            report = report_of("land")
            plants = sum(tile["instances"] for tile in report["tiles"])
            drawn = measured("preview", "land", "--level", "0", *SMALL, "--spp", "1", "--view", "overview", "-o", "l.png")
            rows.append([name, density, plants, report["levels"][0]["triangles"], megabytes("land/glb/*"), done.cpu_s, drawn.cpu_s, drawn.memory_mb])
    return table(["land", "density of woods", "instances", "triangles", "MB", "compile (CPU s)", "picture (CPU s)", "memory (MB)"], rows)


@study(28)
def all_buildings():
    rows = []
    for tolerance in ("12.5", "2.5", "0.5"):
        done = measured("compile", DATA / "neubrandenburg/neubrandenburg.osm.bz2", "--lods", tolerance, "--layers", "buildings", "--assume", "none",
                        "--surroundings", "none", "-o", "town")
        report = report_of("town")
        rows.append([float(tolerance), report["counts"]["buildings"], report["levels"][0]["triangles"], megabytes("town/glb/*"), done.cpu_s])
    return table(["tolerance (m)", "buildings", "triangles", "MB", "CPU s of the whole compile"], rows)


@study(29)
def surfaces():
    _, said = series_of("smooth", "--dem", DATA / "andorra/N42E001.hgt", "--dem", DATA / "monaco/N43E007.hgt")
    return "\n".join(line for line in said.splitlines() if line.startswith("|"))


# ---- running ----

def write_section(number, text):
    """Replaces what a section of the page has after the line that names its command."""
    page = PAGE.read_text()
    command = f"`tests/bench/works.py {number}`"
    pattern = re.compile(rf"(^## {number}\. .*?{re.escape(command)}[^\n]*\n\n).*?(?=^## |\Z)", re.MULTILINE | re.DOTALL)
    if not pattern.search(page):
        sys.exit(f"{PAGE.name} has no section {number} with the command {command}")
    page = pattern.sub(lambda match: match[1] + text + "\n\n", page)
    PAGE.write_text(re.sub(rf"^(\| {number} \|.*\| )not run( \|)$", r"\1yes\2", page, flags=re.MULTILINE))


def main():
    numbers = [int(word) for word in sys.argv[1:]] or sorted(STUDIES)
    for number in numbers:
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            text = STUDIES[number]()
        print(f"{number}\n{text}\n", flush=True)
        write_section(number, text)


if __name__ == "__main__":
    main()
