"""Brings a run into a scene: chooses files, builds their objects, sets the world. Both commands of the menu end here."""
import json
import time
from dataclasses import dataclass, field, replace
from pathlib import Path

import mathutils

from .choice import Choice, Viewer, chosen_tiles
from .light import apply_light, light_of_run
from .materials import Materials
from .meshes import Meshes
from .earlier_run import TILE_KEY, begin_run, forget_tile, forget_unused
from .objects import Builder
from .run_folder import LAYERS, Run, RunError
from .scene_origin import keep_origin, place_run
from .tile import Tile
from .view import set_view


@dataclass
class Wishes:
    """The choices of a user."""
    choice: Choice = field(default_factory=Choice)
    by_distance: bool = False
    pixel_error: float = 1
    layers: set = field(default_factory=lambda: set(LAYERS))
    has_lamps: bool = True
    has_single_buildings: bool = True
    has_sky: bool = True
    has_surroundings: bool = True
    has_clouds: bool = True
    has_view: bool = True


# of a run's collection: what of it was wanted
WANTED = "citykiln_wanted"


def note_wishes(collection, wishes):
    collection[WANTED] = json.dumps({"layers": sorted(wishes.layers), "has_lamps": wishes.has_lamps,
                                     "has_single_buildings": wishes.has_single_buildings})


def wishes_of(collection, **more):
    """The wishes by which a run was imported, with other ones set."""
    noted = json.loads(collection.get(WANTED, "{}"))
    if "layers" in noted:
        noted["layers"] = set(noted["layers"])
    return replace(Wishes(), **noted, **more)


def bring_in(context, folder, wishes, on_progress=lambda share: None):
    """Imports a run and returns a sentence about it. Errors: RunError, GlbError."""
    start_s = time.time()
    run = Run(folder)
    placement = place_run(context.scene, run)
    if wishes.by_distance:
        wishes.choice.viewer = viewer_of(context.scene, placement, wishes.pixel_error)
    files = files_of(run, wishes)
    collection = begin_run(context.scene, run, keeps_tiles=wishes.choice.is_part())
    note_wishes(collection, wishes)
    materials = Materials()
    builder = Builder(collection, Meshes(materials), materials, placement, wishes.layers | {"surroundings", "clouds"},
                      wishes.has_lamps, wishes.has_single_buildings)
    for i, file in enumerate(files):
        on_progress(i / len(files))
        add_file(builder, file)
    builder.place_all()
    note_boxes(collection)
    context.scene.collection.children.link(collection)
    keep_origin(context.scene, run)
    forget_unused()
    notes = light_of_run(context.scene, run) if wishes.has_sky else []
    apply_light(context.scene)
    if wishes.has_view:
        set_view(context.scene, collection, any(file.key == "surroundings" for file in files))
    return ". ".join([f"{run.name}: {len(files)} files, {len(collection.all_objects)} objects in {time.time() - start_s:.1f} s", *notes])


@dataclass
class File:
    """A file to import: `key` is the same for all levels of a tile."""
    key: str
    name: str
    path: Path
    level: int = None


def add_file(builder, file):
    """Adds the objects of a file, in place of those that its tile had in an earlier import."""
    forget_tile(builder.run_collection, file.key)
    tile = Tile(file.path)
    group = builder.add_tile(tile, file.name)
    group[TILE_KEY] = file.key
    if file.level is not None:
        group["level"] = file.level


def add_finer(context, run, file):
    """Replaces a tile of an imported run by a file that the run's report does not list."""
    collection = begin_run(context.scene, run, keeps_tiles=True)
    materials = Materials()
    wishes = wishes_of(collection)
    builder = Builder(collection, Meshes(materials), materials, place_run(context.scene, run), wishes.layers, wishes.has_lamps,
                      wishes.has_single_buildings)
    add_file(builder, file)
    builder.place_all()
    note_boxes(collection)
    context.scene.collection.children.link(collection)
    forget_unused()
    apply_light(context.scene)


def note_boxes(collection):
    """Gives tiles that are new their box, for cameras."""
    for group in collection.children:
        if "level" in group and "box_m" not in group:
            group["box_m"] = box_of_meshes(group)


def box_of_meshes(group):
    """The least and largest coordinates of a tile's merged meshes and buildings, in the scene's metres."""
    corners = [thing.matrix_basis @ mathutils.Vector(corner) for thing in group.all_objects
               if thing.type == "MESH" and thing.data.users == 1 for corner in thing.bound_box]
    return [f(corner[i] for corner in corners) for f in (min, max) for i in range(3)] if corners else [0] * 6


def files_of(run, wishes):
    """The files to import."""
    files = [File(tile.name, f"Tile {tile.name}, level {tile.level}", tile.path, tile.level) for tile in chosen_tiles(run, wishes.choice)]
    if wishes.has_surroundings and not wishes.choice.is_part() and run.surroundings() is not None:
        files.append(File("surroundings", "Surroundings", run.surroundings()))
    if wishes.has_clouds and run.clouds() is not None:
        files.append(File("clouds", "Clouds", run.clouds()))
    return files


def viewer_of(scene, placement, pixel_error):
    """The scene's camera as a viewer, in the run's metres."""
    camera = scene.camera
    if camera is None or camera.type != "CAMERA" or camera.data.type != "PERSP":
        raise RunError("levels by distance: the scene has no perspective camera; add one, or choose one level")
    render = scene.render
    largest_px = max(render.resolution_x, render.resolution_y) * render.resolution_percentage / 100
    focal_px = largest_px * camera.data.lens / camera.data.sensor_width
    return Viewer(tuple(placement.inverted() @ camera.matrix_world.translation), focal_px, pixel_error)
