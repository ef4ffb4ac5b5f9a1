"""Removes from a scene the objects of an earlier import of the same run, which a new import replaces."""
import bpy

from .materials import KEY as MADE

# of a run's collection: its folder; of a tile's collection: the tile, at any level
FOLDER, TILE_KEY = "citykiln_folder", "citykiln_tile"


def begin_run(scene, run, keeps_tiles):
    """A collection for a run, not linked to the scene yet. @param keeps_tiles  Those of an earlier import stay in it."""
    folder = str(run.folder.resolve())
    collection = next((each for each in scene.collection.children if each.get(FOLDER) == folder), None)
    if collection is None:
        collection = bpy.data.collections.new(run.name)
    else:
        scene.collection.children.unlink(collection)
        for tile in [] if keeps_tiles else list(collection.children):
            remove_tree(tile)
    collection[FOLDER] = folder
    collection["lon_0"], collection["lat_0"] = run.origin_deg
    return collection


def forget_tile(collection, key):
    """Removes a tile that an earlier import brought."""
    for tile in list(collection.children):
        if tile.get(TILE_KEY) == key:
            remove_tree(tile)


def remove_tree(collection):
    """Removes a collection with all below it, and the meshes and lights that only these objects had. Objects that a user also put
    into another collection stay."""
    below = [collection, *collection.children_recursive]
    own = [thing for thing in collection.all_objects if all(user in below for user in thing.users_collection)]
    data = {thing.data for thing in own if thing.data is not None}
    bpy.data.batch_remove(own)
    bpy.data.batch_remove([each for each in data if each.users == 0])
    bpy.data.batch_remove(below)


def forget_unused():
    """Removes materials and pictures of runs that nothing shows any more."""
    for kind in (bpy.data.materials, bpy.data.images):
        bpy.data.batch_remove([each for each in kind if MADE in each and each.users == 0])
