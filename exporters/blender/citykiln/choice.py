"""Chooses the tiles of a run to import, and the level of each. Does not need Blender."""
from dataclasses import dataclass

from .run_folder import RunError, heights_of


@dataclass
class Viewer:
    """A camera: its place in the run's metres, its focal length in pixels, and the largest error on its picture."""
    eye: tuple
    focal_px: float
    pixel_error: float


@dataclass
class Choice:
    level: int = 0
    viewer: Viewer = None   # instead of the level
    tiles: str = ""         # such as "0_0, -1_2"; empty: all
    box_deg: str = ""       # west, south, east, north; empty: all

    def is_part(self):
        return bool(self.tiles.strip() or self.box_deg.strip())


def chosen_tiles(run, choice):
    """The files to import, one for each chosen tile. Error: the run has none of them."""
    names, box = names_of(choice.tiles), box_of(choice.box_deg)
    known = {tile.name for tile in run.tiles}
    unknown = sorted(names - known)
    if unknown:
        raise RunError(f"{run.folder}: has no tile {unknown[0]}; its tiles are {', '.join(sorted(known))}")
    by_tile = {}
    for tile in run.tiles:
        if (not names or tile.name in names) and (box is None or overlap(box, tile.box_deg)):
            by_tile.setdefault(tile.name, []).append(tile)
    if not by_tile:
        raise RunError(f"{run.folder}: no tile lies in the box {choice.box_deg}")
    return [level_of(run, sorted(levels, key=lambda tile: tile.level), choice) for levels in by_tile.values()]


def level_of(run, levels, choice):
    """The file of one tile. @param levels  Its files, finest first."""
    if choice.viewer is not None:
        return level_for_viewer(run, levels, choice.viewer)
    for tile in levels:
        if tile.level == choice.level:
            return tile
    raise RunError(f"{run.folder}: has no level {choice.level}; its levels are {', '.join(str(tile.level) for tile in levels)}")


def level_for_viewer(run, levels, viewer):
    """The coarsest file whose error on the picture is as small as wanted; else the finest."""
    distance_m = distance_to(run, levels[-1], viewer.eye)
    for tile in reversed(levels):
        if tile.error_m * viewer.focal_px <= viewer.pixel_error * distance_m:
            return tile
    return levels[0]


def distance_to(run, tile, eye):
    """The distance from a place to the box of a tile, in metres."""
    low_m, high_m = heights_of(tile.path)
    ranges = [(tile.x * run.tile_m, (tile.x + 1) * run.tile_m), (tile.y * run.tile_m, (tile.y + 1) * run.tile_m), (low_m, high_m)]
    return sum(max(low - at, at - high, 0) ** 2 for at, (low, high) in zip(eye, ranges)) ** 0.5


def names_of(text):
    names = {name.strip() for name in text.replace(";", ",").split(",")} - {""}
    for name in names:
        x, _, y = name.partition("_")
        if not (x.lstrip("-").isdigit() and y.lstrip("-").isdigit()):
            raise RunError(f'tiles: "{name}" is no tile; expected a list such as 0_0, -1_2')
    return names


def box_of(text):
    """The four numbers of a box in degrees; None for an empty text."""
    if not text.strip():
        return None
    try:
        west, south, east, north = map(float, text.split(","))
    except ValueError:
        west = south = east = north = 0
    if not (west < east and south < north):
        raise RunError(f'box: "{text}" is no box; expected west,south,east,north in degrees, such as 7.41,43.73,7.43,43.74')
    return [west, south, east, north]


def overlap(a, b):
    return a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]
