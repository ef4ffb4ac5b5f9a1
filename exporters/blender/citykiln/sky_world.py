"""Sun and sky of a scene in Blender: one world and one sun, in watts of 683 lumen, as lamps are; both are made once and then turned."""
import math

import bpy
import mathutils

from .twilight import share_of_blender, twilight

LUMEN_PER_WATT = 683
# of the sun outside the air, in lux, and its width in the sky
SUN_LX, SUN_DEG = 128e3, 0.53
# micrometres: red, green, blue
WAVELENGTHS = (0.61, 0.55, 0.465)
# Blender's skies, the newest last, and their strength. NISHITA leaves out light that is scattered more than once: by Cycles the
# preview's sky is 1.4 to 2.6 times as bright opposite a sun of 10 to 60 degrees, and gives level ground 2.5 to 3.3 times the
# light. MULTIPLE_SCATTERING, since Blender 5.0, is not measured.
SKY_STRENGTHS = {"NISHITA": 2, "MULTIPLE_SCATTERING": 1}
# how fast the horizon of twilight darkens away from the sun: half of it is left at 53 degrees
GLOW = 3
SKY, SUN = "citykiln sky", "citykiln sun"


def turn_sky(scene, to_sun, turbidity, ground_m):
    """Gives the scene Blender's own sky for a sun in this direction; the sun itself is a light, which Eevee shows too."""
    if scene.world is None or scene.world.get(SKY) is None:
        scene.world = make_sky()
    nodes = scene.world.node_tree.nodes
    texture = next(node for node in nodes if node.type == "TEX_SKY")
    texture.sun_elevation, texture.sun_rotation = math.asin(to_sun.z), math.atan2(to_sun.x, to_sun.y)
    texture.altitude = max(ground_m, 0)
    turn_twilight(nodes, to_sun)
    # 1 is the haze of a usual day; the run's turbidity of a usual day is 2.6
    set_first(texture, "dust_density" if hasattr(texture, "dust_density") else "aerosol_density", (turbidity / 2.6,))


def make_sky():
    world = bpy.data.worlds.new(SKY)
    world[SKY] = True
    world.use_nodes = True
    nodes = world.node_tree.nodes
    background = next(node for node in nodes if node.type == "BACKGROUND")
    texture = nodes.new("ShaderNodeTexSky")
    texture.location = (-300, 300)
    set_first(texture, "sky_type", SKY_STRENGTHS)
    texture.sun_disc = False
    background.inputs["Strength"].default_value = SKY_STRENGTHS[texture.sky_type]
    world.node_tree.links.new(texture.outputs["Color"], background.inputs["Color"])
    add_twilight(world.node_tree, background)
    return world


def add_twilight(tree, background):
    """Adds a second sky, and a node that mixes both: from the zenith to a horizon that is brighter towards the sun."""
    def add(kind, name, x, y, **values):
        node = tree.nodes.new(kind)
        node.name, node.location = name, (x, y)
        for key, value in values.items():
            setattr(node, key, value)
        return node

    def mix(name, x, y, factor, first=None, second=None):
        node = add("ShaderNodeMixRGB", name, x, y)
        for socket, end in zip(node.inputs, (factor, first, second)):
            if end is not None:
                tree.links.new(end, socket)
        return node.outputs[0]

    ray = add("ShaderNodeTexCoord", "ray", -1400, -200).outputs["Generated"]
    up = add("ShaderNodeSeparateXYZ", "up", -1200, -300)
    tree.links.new(ray, up.inputs[0])
    height = add("ShaderNodeMath", "height", -1000, -300, operation="POWER", use_clamp=True)
    above = add("ShaderNodeMath", "above", -1100, -300, operation="MAXIMUM")
    tree.links.new(up.outputs["Z"], above.inputs[0])
    above.inputs[1].default_value = 0
    tree.links.new(above.outputs[0], height.inputs[0])
    height.inputs[1].default_value = 0.5
    dot = add("ShaderNodeVectorMath", "to sun", -1200, -100, operation="DOT_PRODUCT")
    tree.links.new(ray, dot.inputs[0])
    towards = add("ShaderNodeMapRange", "towards", -1000, -100)
    tree.links.new(dot.outputs["Value"], towards.inputs["Value"])
    towards.inputs["From Min"].default_value = -1
    near = add("ShaderNodeMath", "near", -900, -100, operation="POWER")
    tree.links.new(towards.outputs[0], near.inputs[0])
    near.inputs[1].default_value = GLOW
    horizon = mix("horizon", -800, -100, near.outputs[0])
    sky = mix("zenith", -600, -200, height.outputs[0], horizon)
    night = add("ShaderNodeBackground", "twilight", -300, -200)
    tree.links.new(sky, night.inputs["Color"])
    both = add("ShaderNodeMixShader", "share of Blender's sky", 100, 100)
    tree.links.new(night.outputs[0], both.inputs[1])
    tree.links.new(background.outputs[0], both.inputs[2])
    output = next(node for node in tree.nodes if node.type == "OUTPUT_WORLD")
    tree.links.new(both.outputs[0], output.inputs["Surface"])


def turn_twilight(nodes, to_sun):
    """Gives the second sky the colours of a sun in this direction."""
    elevation_deg = math.degrees(math.asin(to_sun.z))
    zenith, away, towards = twilight(elevation_deg)
    flat = mathutils.Vector((to_sun.x, to_sun.y, 0))
    nodes["to sun"].inputs[1].default_value = flat.normalized() if flat.length > 0 else flat
    nodes["horizon"].inputs[1].default_value, nodes["horizon"].inputs[2].default_value = (*away, 1), (*towards, 1)
    nodes["zenith"].inputs[2].default_value = (*zenith, 1)
    nodes["share of Blender's sky"].inputs[0].default_value = share_of_blender(elevation_deg)


def turn_sun(scene, to_sun, turbidity):
    """Turns the scene's light for the sun, and gives it the colour that the air leaves it. It is hidden after sunset."""
    sun = next((thing for thing in scene.collection.objects if SUN in thing), None) or add_sun(scene)
    shares = transmission(max(to_sun.z, 0), turbidity)
    sun.data.energy = SUN_LX / LUMEN_PER_WATT * max(shares)
    sun.data.color = [share / max(shares) for share in shares]
    sun.rotation_euler = to_sun.to_track_quat("Z", "Y").to_euler()
    sun.hide_render = sun.hide_viewport = to_sun.z <= 0


def add_sun(scene):
    light = bpy.data.lights.new(SUN, "SUN")
    light.angle = math.radians(SUN_DEG)
    sun = bpy.data.objects.new(SUN, light)
    sun[SUN] = True
    scene.collection.objects.link(sun)
    return sun


def transmission(sine, turbidity):
    """Shares of sunlight that pass the air, for red, green and blue: scattering by air and haze (Preetham et al. 1999, appendix),
    along the air mass of Kasten and Young (1989)."""
    elevation_deg = math.degrees(math.asin(sine))
    mass = 1 / (sine + 0.50572 * (elevation_deg + 6.07995) ** -1.6364)
    haze = max(0.04608 * turbidity - 0.04586, 0)
    return [math.exp(-mass * (0.008735 * length ** -4.08 + haze * length ** -1.3)) for length in WAVELENGTHS]


def direction_of(elevation, azimuth):
    """A unit vector: east, north, up. @param azimuth  From north to east."""
    flat = math.cos(elevation)
    return mathutils.Vector((flat * math.sin(azimuth), flat * math.cos(azimuth), math.sin(elevation)))


def set_first(thing, name, values):
    """Sets a property to the first of these values that this version of Blender has."""
    for value in values:
        try:
            return setattr(thing, name, value)
        except TypeError:
            continue
