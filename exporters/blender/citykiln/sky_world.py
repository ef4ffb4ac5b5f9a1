"""Sun and sky of a run: a world and a sun, in watts of 683 lumen, as lamps are."""
import math

import bpy
import mathutils

LUMEN_PER_WATT = 683
# of the sun outside the air, in lux, and its width in the sky
SUN_LX, SUN_DEG = 128e3, 0.53
# micrometres: red, green, blue
WAVELENGTHS = (0.61, 0.55, 0.465)
# level white ground in the sun, times the exposure: as bright as citykiln's preview meters the streets of the example town
WHITE = 1.8
# Blender's skies, the newest last, and their strength. NISHITA leaves out light that is scattered more than once: by Cycles the
# preview's sky is 1.4 to 2.6 times as bright opposite a sun of 10 to 60 degrees, and gives level ground 2.5 to 3.3 times the
# light. MULTIPLE_SCATTERING, since Blender 5.0, is not measured.
SKY_STRENGTHS = {"NISHITA": 2, "MULTIPLE_SCATTERING": 1}


def set_world(scene, run):
    """Sets the scene's world, sun and exposure. Returns notes for the user."""
    if run.sky is None:
        return ["report.json has no sky, so the world stays as it is: compile the map again"]
    to_sun = mathutils.Vector(run.sky["to_sun"])
    scene.world = sky_world(run.sky, to_sun)
    if to_sun.z > 0:
        add_sun(scene, to_sun, run.sky["turbidity"])
    scene.view_settings.exposure = exposure_of(to_sun.z, run.sky["turbidity"])
    return []


def sky_world(sky, to_sun):
    """A world with Blender's own sky; the sun is a light, which Eevee shows too."""
    world = bpy.data.worlds.new("citykiln sky")
    world.use_nodes = True
    nodes = world.node_tree.nodes
    background = next(node for node in nodes if node.type == "BACKGROUND")
    texture = nodes.new("ShaderNodeTexSky")
    texture.location = (-300, 300)
    set_first(texture, "sky_type", SKY_STRENGTHS)
    texture.sun_disc = False
    texture.sun_elevation, texture.sun_rotation = math.asin(to_sun.z), math.atan2(to_sun.x, to_sun.y)
    texture.altitude = max(sky["ground_m"], 0)
    # 1 is the haze of a usual day; the run's turbidity of a usual day is 2.6
    set_first(texture, "dust_density" if hasattr(texture, "dust_density") else "aerosol_density", (sky["turbidity"] / 2.6,))
    background.inputs["Strength"].default_value = SKY_STRENGTHS[texture.sky_type]
    world.node_tree.links.new(texture.outputs["Color"], background.inputs["Color"])
    return world


def add_sun(scene, to_sun, turbidity):
    """A light for the sun, of the colour that the air leaves it."""
    shares = transmission(to_sun.z, turbidity)
    light = bpy.data.lights.new("citykiln sun", "SUN")
    light.angle = math.radians(SUN_DEG)
    light.energy = SUN_LX / LUMEN_PER_WATT * max(shares)
    light.color = [share / max(shares) for share in shares]
    sun = bpy.data.objects.new("citykiln sun", light)
    sun.rotation_euler = to_sun.to_track_quat("Z", "Y").to_euler()
    scene.collection.objects.link(sun)


def transmission(sine, turbidity):
    """Shares of sunlight that pass the air, for red, green and blue: scattering by air and haze (Preetham et al. 1999, appendix),
    along the air mass of Kasten and Young (1989)."""
    elevation_deg = math.degrees(math.asin(sine))
    mass = 1 / (sine + 0.50572 * (elevation_deg + 6.07995) ** -1.6364)
    haze = max(0.04608 * turbidity - 0.04586, 0)
    return [math.exp(-mass * (0.008735 * length ** -4.08 + haze * length ** -1.3)) for length in WAVELENGTHS]


def exposure_of(sine, turbidity):
    """Stops at which a street is bright: by day of the sun's and the sky's light, after sunset 6 stops more at most, one for each
    degree, as citykiln's preview has."""
    direct = transmission(max(sine, 0.02), turbidity)[1] * max(sine, 0.02)
    radiance = SUN_LX / LUMEN_PER_WATT * (direct + 0.1) / math.pi
    after_sunset = min(max(-math.degrees(math.asin(sine)), 0), 6)
    return math.log2(WHITE / radiance) + after_sunset


def set_first(thing, name, values):
    """Sets a property to the first of these values that this version of Blender has."""
    for value in values:
        try:
            return setattr(thing, name, value)
        except TypeError:
            continue
