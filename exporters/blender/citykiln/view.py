"""The camera of a scene with a run, and the distances at which cameras and views of Blender stop."""
import math

import bpy
import mathutils

# of the preview's overview: the direction from the scene to the eye, and the vertical angle in degrees
TOWARDS_EYE, FOV_DEG = (0.52, -0.85, 0.5), 35
CLIP_START_M, LEAST_CLIP_END_M = 0.5, 5000
# of the diagonal: as far as cameras see
CLIP_DIAGONALS = 4


def set_view(scene, collection, has_surroundings):
    """Adds a camera that shows a run, unless the scene has one; lets it and all views see as far as the run goes."""
    low, high = box_of(collection)
    if low is None:
        return
    clip_end_m = max(LEAST_CLIP_END_M, CLIP_DIAGONALS * (high - low).length, 60e3 if has_surroundings else 0)
    if scene.camera is None:
        scene.camera = add_camera(scene, low, high)
    if scene.camera.type == "CAMERA":
        scene.camera.data.clip_end = max(scene.camera.data.clip_end, clip_end_m)
    for space in views_of(bpy.data.screens):
        set_space(space, low, high, clip_end_m)


def box_of(collection):
    """The corners of the tiles below a collection, without the surroundings; None for none."""
    corners = []
    for tile in collection.children:
        if "tile" in tile and "box_m" in tile:
            values = list(tile["box_m"])
            corners += [mathutils.Vector(values[:3]), mathutils.Vector(values[3:])]
    if not corners:
        return None, None
    return (mathutils.Vector(f(corner[i] for corner in corners) for i in range(3)) for f in (min, max))


def add_camera(scene, low, high):
    """A camera to the south-east of a box, as far away as the box fits into its picture."""
    data = bpy.data.cameras.new("citykiln camera")
    data.sensor_fit, data.clip_start = "VERTICAL", CLIP_START_M
    data.angle_y = math.radians(FOV_DEG)
    camera = bpy.data.objects.new("citykiln camera", data)
    towards = mathutils.Vector(TOWARDS_EYE).normalized()
    camera.rotation_euler = towards.to_track_quat("Z", "Y").to_euler()
    render = scene.render
    camera.location = (low + high) / 2 + towards * fitting_distance(low, high, camera, render.resolution_x / render.resolution_y)
    scene.collection.objects.link(camera)
    return camera


def fitting_distance(low, high, camera, aspect):
    """The distance from a box's middle at which all of its corners are in the picture."""
    slope = math.tan(camera.data.angle_y / 2)
    back = camera.rotation_euler.to_matrix().transposed()
    middle, most = (low + high) / 2, 0
    for number in range(8):
        corner = mathutils.Vector(((low, high)[number >> i & 1])[i] for i in range(3))
        x, y, z = back @ (corner - middle)
        most = max(most, z + abs(x) / (slope * aspect), z + abs(y) / slope)
    return most


def views_of(screens):
    return [space for screen in screens for area in screen.areas if area.type == "VIEW_3D" for space in area.spaces
            if space.type == "VIEW_3D"]


def set_space(space, low, high, clip_end_m):
    space.clip_start, space.clip_end = CLIP_START_M, max(space.clip_end, clip_end_m)
    space.lens = 35
    region = space.region_3d
    region.view_location, region.view_distance = (low + high) / 2, (high - low).length * 0.6
    region.view_rotation = mathutils.Vector(TOWARDS_EYE).to_track_quat("Z", "Y")
