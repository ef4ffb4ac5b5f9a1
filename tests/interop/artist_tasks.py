"""Runs in Blender: does ten tasks as an artist would, with the add-on alone, and writes which were done.

A job is a JSON file: `zip`, `facts` (a file to write), `run` (the town with two levels and lamps), `map`, `edits` (a file that gives way
`house` nine storeys), `program`, `pictures` (a folder), `street` (eye and look in metres).
"""
import json
import sys

import bpy
import mathutils

job = json.load(open(sys.argv[sys.argv.index("--") + 1], encoding="utf-8"))
done = {}


def task(function):
    """Does a task, and notes whether it was done."""
    try:
        function()
        done[function.__name__] = True
    except Exception as error:
        done[function.__name__] = f"{type(error).__name__}: {error}"


def expect(is_so, words):
    if not is_so:
        raise ValueError(words)


def scene():
    return bpy.context.scene


def things(**facts):
    return [thing for thing in scene().objects if all(str(thing.get(key)) == value for key, value in facts.items())]


def mean_of_picture(name):
    """Renders what the camera sees, and returns the mean of its values, 0 to 1."""
    path = f"{job['pictures']}/{name}.png"
    scene().render.filepath = path
    bpy.ops.render.render(write_still=True)
    picture = bpy.data.images.load(path)
    values = list(picture.pixels)
    return sum(sum(values[channel::4]) for channel in range(3)) / (3 * len(values) / 4)


def imports_a_town():
    bpy.ops.import_scene.citykiln_run(directory=job["run"], level=1)
    expect(len(scene().objects) > 500, "few objects")


def renders_a_street_at_noon():
    camera = scene().camera
    eye, look = map(mathutils.Vector, job["street"])
    camera.location, camera.data.lens = eye, 24
    camera.rotation_euler = (look - eye).to_track_quat("-Z", "Y").to_euler()
    scene().render.engine, scene().cycles.samples, scene().cycles.use_denoising = "CYCLES", 16, False
    scene().render.resolution_x, scene().render.resolution_y = 480, 270
    scene().citykiln.hour = 12
    mean = mean_of_picture("noon")
    expect(0.25 < mean < 0.75, f"mean {mean:.2f}")


def renders_it_at_dusk_with_lamps():
    scene().citykiln.hour = 19.9
    lamps = [group for group in bpy.data.collections if "citykiln_lamps" in group]
    expect(lamps and not any(group.hide_render for group in lamps), "lamps are dark")
    mean = mean_of_picture("dusk")
    expect(0.04 < mean < 0.6, f"mean {mean:.2f}")


def turns_the_sun_by_keyframes():
    [sun] = [thing for thing in scene().objects if thing.type == "LIGHT" and thing.data.type == "SUN"]
    for frame, hour in ((1, 8), (50, 16)):
        scene().citykiln.hour = hour
        scene().citykiln.keyframe_insert("sun_elevation", frame=frame)
        scene().citykiln.keyframe_insert("sun_azimuth", frame=frame)
    ways = []
    for frame in (1, 50):
        scene().frame_set(frame)
        ways.append(sun.matrix_world.to_quaternion() @ mathutils.Vector((0, 0, 1)))
    scene().animation_data_clear()
    expect(ways[0].angle(ways[1]) > 0.5, "the sun stands still")


def finds_a_building_by_its_name():
    [found] = things(name=job["named"])[:1]
    expect(job["named"] in found.name, "the outliner does not show the name")
    bpy.context.view_layer.objects.active = found
    expect(str(found.get("osm_id")), "no id")


def hides_a_layer():
    groups = [group for group in bpy.data.collections if group.name.split(".")[0].endswith(" plants")]
    expect(groups, "no layer of plants")
    for group in groups:
        group.hide_render = group.hide_viewport = True


def swaps_a_landmark():
    [house] = things(name=job["named"])[:1]
    low = min(corner[2] for corner in house.bound_box)
    expect(abs(low) < 0.01, f"its origin lies {-low:.2f} m above its foot")
    bpy.ops.mesh.primitive_cone_add(radius1=10, depth=40)
    cone = bpy.context.object
    cone.data.transform(mathutils.Matrix.Translation((0, 0, 20)))
    cone.matrix_world = house.matrix_world
    house.hide_render = True


def makes_what_is_selected_finer():
    [house] = things(name=job["named"])[:1]
    for thing in scene().objects:
        thing.select_set(thing == house)
    bpy.ops.scene.citykiln_finer(program=job["program"])
    levels = {group["level"] for group in bpy.data.collections if "level" in group}
    expect(levels == {0, 1}, f"levels {levels}")


def chooses_levels_by_distance():
    bpy.ops.import_scene.citykiln_run(directory=job["run"], by_distance=True, pixel_error=20)
    levels = {group["level"] for group in bpy.data.collections if "level" in group and "citykiln_tile" in group}
    expect(len(levels) > 1, f"levels {levels}")


def adds_storeys():
    before = max(thing["height_m"] for thing in things(osm_id=job["house"]))
    bpy.ops.import_scene.citykiln_map(filepath=job["map"], heightmaps=job["heights"], options=f"--edits {job['edits']} --lods 2.5",
                                      out=f"{job['pictures']}/edited", program=job["program"])
    after = max(thing["height_m"] for thing in things(osm_id=job["house"]))
    expect(after > before + 5, f"{before} m, then {after} m")


bpy.ops.preferences.addon_install(filepath=job["zip"], overwrite=True)
bpy.ops.preferences.addon_enable(module="citykiln")
for each in (imports_a_town, renders_a_street_at_noon, renders_it_at_dusk_with_lamps, turns_the_sun_by_keyframes, finds_a_building_by_its_name,
             hides_a_layer, swaps_a_landmark, makes_what_is_selected_finer, chooses_levels_by_distance, adds_storeys):
    task(each)
with open(job["facts"], "w", encoding="utf-8") as out:
    json.dump(done, out)
