"""The folder of a run of citykiln: its report, its tiles and the other files to import. Does not need Blender."""
import json
from dataclasses import dataclass
from pathlib import Path

from .glb import GlbError, GlbFile

LAYERS = ["ground", "roads", "water", "buildings", "structures", "props", "plants"]


class RunError(Exception):
    """A folder that cannot be imported. The text is one line: the file, and what was expected."""


@dataclass
class TileFile:
    """One tile at one level."""
    x: int
    y: int
    level: int
    error_m: float
    path: Path
    bytes: int
    box_deg: list  # west, south, east, north

    @property
    def name(self):
        return f"{self.x}_{self.y}"


class Run:
    """A run: name, origin_deg (longitude, latitude), tile_m, tiles, report, sky (None in reports of older versions)."""

    def __init__(self, folder):
        self.folder = Path(folder)
        report = read_report(self.folder)
        try:
            self._take(report)
        except (KeyError, TypeError, AttributeError):
            raise RunError(f"{self.folder / 'report.json'}: is of another version of citykiln: compile the map again, with "
                           "the citykiln that wrote this add-on") from None
        self.name = self.folder.resolve().name
        self._check_files()

    def surroundings(self):
        return self._file_if_there("surroundings.glb")

    def clouds(self):
        return self._file_if_there("clouds.glb")

    def _take(self, report):
        self.origin_deg = (report["origin"]["lon_deg"], report["origin"]["lat_deg"])
        self.report = report
        self.tile_m, self.sky = report["tile_m"], report.get("sky")
        self.tiles = [TileFile(tile["x"], tile["y"], tile["level"], tile["error_m"], self.folder / tile["file"], tile["bytes"],
                               tile["box_deg"]) for tile in report["tiles"]]

    def _check_files(self):
        """Error: no tiles, or a tile that is not the file which the report lists."""
        if not self.tiles:
            raise RunError(f"{self.folder}: has no tiles as .glb: compile the map again with --emit kiln,glb")
        for tile in self.tiles:
            if not tile.path.is_file():
                raise RunError(f"{tile.path}: is missing; the run is not complete: compile the map again")
            if tile.path.stat().st_size != tile.bytes:
                raise RunError(f"{tile.path}: has {tile.path.stat().st_size} bytes, but {tile.bytes} in report.json: compile the "
                               "map again")

    def _file_if_there(self, name):
        path = self.folder / "glb" / name
        return path if path.is_file() else None


def read_report(folder):
    if not folder.is_dir():
        raise RunError(f"{folder}: there is no such folder")
    try:
        report = json.loads((folder / "report.json").read_text(encoding="utf-8"))
    except FileNotFoundError:
        raise RunError(f"{folder}: is not the folder of a run of citykiln: it has no report.json") from None
    except (OSError, ValueError):
        raise RunError(f"{folder / 'report.json'}: cannot be read as JSON: compile the map again") from None
    return report


def heights_of(path):
    """The lowest and the highest vertex of a tile, in metres, by the limits that its accessors state."""
    gltf = GlbFile(path).gltf
    numbers = {p["attributes"]["POSITION"] for mesh in gltf.get("meshes", []) for p in mesh["primitives"]}
    if not numbers:
        return 0, 0
    boxes = [gltf["accessors"][number] for number in numbers]
    up_m = gltf["nodes"][0].get("translation", [0, 0, 0])[1]
    return min(box["min"][1] for box in boxes) + up_m, max(box["max"][1] for box in boxes) + up_m


__all__ = ["GlbError", "LAYERS", "Run", "RunError", "TileFile", "heights_of"]
