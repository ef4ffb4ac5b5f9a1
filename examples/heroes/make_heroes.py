#!/usr/bin/env python3
"""Renders twelve pictures of invented places on six continents, and of the example town.

make_heroes.py BUILD OUT [NAME …]: all, or those whose names begin so. BUILD holds citykiln. --size 480x270 and --spp 8
make drafts; --print shows the commands and runs none. Each picture is one command of `citykiln preview`, printed before
it runs; places are invented and compiled once. Run it at the top of the repository.
"""
import argparse
import dataclasses
import pathlib
import shlex
import subprocess
import sys
import time


@dataclasses.dataclass
class Place:
    """A world by `citykiln invent`: kind, seed, side in metres, place on the Earth; and options of `compile`."""

    kind: str
    seed: int
    size_m: int
    lon_lat: str
    options: str = ""


@dataclasses.dataclass
class Hero:
    """A picture: the place (a key of PLACES, or "example"), the named view, the time in UTC, and further options."""

    place: str
    view: str
    utc: str
    options: str = ""


PLACES = {
    "germany": Place("town", 3, 1024, "12.3,48.7"),
    "greece": Place("town", 5, 1024, "23.9,38.1"),
    "finland": Place("town", 8, 1024, "25.7,65.0", "--time 2026-01-20T10:20"),
    "illinois": Place("city", 4, 1536, "-87.7,41.9"),
    "arizona": Place("town", 6, 1024, "-112.0,33.5"),
    "brazil": Place("city", 9, 1280, "-46.6,-23.5"),
    "nigeria": Place("town", 2, 1024, "3.4,6.6"),
    "japan": Place("town", 7, 1024, "139.6,35.7"),
    "singapore": Place("city", 1, 1280, "103.8,1.35"),
    "australia": Place("town", 12, 1024, "151.1,-33.8"),
}

HEROES = {
    "europe_street_day": Hero("germany", "street", "2026-06-21T08:40"),
    "europe_village_evening": Hero("greece", "low", "2026-07-10T16:10"),
    "europe_snow": Hero("finland", "street", "2026-01-20T10:20"),
    "europe_town_fog": Hero("example", "low", "2026-10-04T06:50", "--fog 0.15"),
    "europe_town_night": Hero("example", "street", "2026-06-21T22:30"),
    "north_america_dusk": Hero("illinois", "low", "2026-06-22T01:45"),
    "north_america_suburb_day": Hero("arizona", "low", "2026-03-21T16:30"),
    "south_america_day": Hero("brazil", "low", "2026-01-15T19:30", "--clouds broken"),
    "africa_street_day": Hero("nigeria", "street", "2026-02-10T08:30"),
    "asia_street_dusk": Hero("japan", "street", "2026-04-10T09:22"),
    "asia_city_night": Hero("singapore", "low", "2026-05-05T13:30"),
    "oceania_park_day": Hero("australia", "park", "2026-11-20T22:30"),
}


def compile_commands(citykiln, out, place):
    """Returns the commands that make the manifest of a place."""
    if place == "example":
        return [f"{citykiln} compile --spec examples/town/spec.json --emit kiln -o {out}/example --quiet"]
    world = PLACES[place]
    return [
        f"{citykiln} invent --kind {world.kind} --seed {world.seed} --size {world.size_m} --place={world.lon_lat} "
        f"-o {out}/{place}/world --quiet",
        f"{citykiln} compile --spec {out}/{place}/world/spec.json --emit kiln {world.options} -o {out}/{place} --quiet",
    ]


def preview_command(citykiln, out, name, size, spp):
    """Returns the command that renders a picture."""
    hero = HEROES[name]
    options = f" {hero.options}" if hero.options else ""
    return (f"{citykiln} preview {out}/{hero.place}/scene.kiln --view {hero.view} --time {hero.utc}{options} "
            f"--size {size} --spp {spp} --unseen-error 1 -o {out}/{name}.png")


def run(command, is_printed_only):
    """Prints a command and runs it."""
    print(command, flush=True)
    if not is_printed_only:
        subprocess.run(shlex.split(command), check=True, stdout=subprocess.DEVNULL)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("names", nargs="*")
    parser.add_argument("--size", default="1920x1080")
    parser.add_argument("--spp", type=int, default=32)
    parser.add_argument("--print", action="store_true", dest="is_printed_only")
    arguments = parser.parse_args()
    names = [name for name in HEROES if not arguments.names or name.startswith(tuple(arguments.names))]
    if not names:
        sys.exit(f"no picture of these names; there are {', '.join(HEROES)}")
    citykiln = arguments.build / "citykiln"
    made = set()
    begin_s = time.monotonic()
    for name in names:
        place = HEROES[name].place
        if place not in made and not (arguments.out / place / "scene.kiln").exists():
            for command in compile_commands(citykiln, arguments.out, place):
                run(command, arguments.is_printed_only)
        made.add(place)
        run(preview_command(citykiln, arguments.out, name, arguments.size, arguments.spp), arguments.is_printed_only)
    print(f"{len(names)} pictures in {(time.monotonic() - begin_s) / 60:.0f} minutes")


if __name__ == "__main__":
    main()
