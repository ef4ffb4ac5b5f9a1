"""Brings a run into a scene: chooses files, builds their objects, sets the world. Both commands of the menu end here."""
import time
from dataclasses import dataclass, field

import bpy

from .choice import Choice, Viewer, chosen_tiles
from .materials import Materials
from .meshes import Meshes
from .objects import Builder
from .run_folder import LAYERS, Run, RunError
from .scene_origin import keep_origin, place_run
from .sky_world import set_world
from .tile import Tile


@dataclass
class Wishes:
    """The choices of a user."""
    choice: Choice = field(default_factory=Choice)
    by_distance: bool = False
    pixel_error: float = 1
    layers: set = field(default_factory=lambda: set(LAYERS))
    has_lamps: bool = False
    has_sky: bool = True
    has_surroundings: bool = True
    has_clouds: bool = True


def bring_in(context, folder, wishes, on_progress=lambda share: None):
    """Imports a run and returns a sentence about it. Errors: RunError, GlbError."""
    start_s = time.time()
    run = Run(folder)
    placement = place_run(context.scene, run)
    if wishes.by_distance:
        wishes.choice.viewer = viewer_of(context.scene, placement, wishes.pixel_error)
    files = files_of(run, wishes)
    collection = bpy.data.collections.new(run.name)
    collection["lon_0"], collection["lat_0"] = run.origin_deg
    materials = Materials()
    builder = Builder(collection, Meshes(materials), materials, placement, wishes.layers | {"surroundings", "clouds"},
                      wishes.has_lamps)
    for i, (name, path) in enumerate(files):
        on_progress(i / len(files))
        builder.add_tile(Tile(path), name)
    context.scene.collection.children.link(collection)
    keep_origin(context.scene, run)
    notes = [] if not wishes.has_sky else set_world(context.scene, run)
    return ". ".join([f"{run.name}: {len(files)} files, {len(collection.all_objects)} objects in {time.time() - start_s:.1f} s", *notes])


def files_of(run, wishes):
    """The names and paths of the files to import."""
    files = [(f"tile_{tile.name}_L{tile.level}", tile.path) for tile in chosen_tiles(run, wishes.choice)]
    is_whole = not wishes.choice.tiles and not wishes.choice.box_deg
    if wishes.has_surroundings and is_whole and run.surroundings() is not None:
        files.append(("surroundings", run.surroundings()))
    if wishes.has_clouds and run.clouds() is not None:
        files.append(("clouds", run.clouds()))
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
