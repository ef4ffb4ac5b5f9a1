"""Names that a person reads, of objects, collections and materials of a run. Does not need Blender."""
import colorsys
import re

# of a material that one tile has for itself: "AsphaltMarked_0_-1_0.5m_2"
OF_TILE = re.compile(r"_-?\d+_-?\d+_[\d.]+m(_\d+)?$")
COLOUR = re.compile(r"_([0-9a-f]{6})$")
NUMBERS = re.compile(r"(_\d+)+$")
TREES = {"apple", "beech", "birch", "cypress", "fir", "larch", "lime", "maple", "oak", "palm", "pine", "plane", "poplar", "spruce", "willow"}
LEAVES = {"broad leaf cutout": "Leaves", "needle leaf cutout": "Needles", "broad leaf": "Leaves", "needle leaf": "Needles"}
# hues in degrees, each up to its end
HUES = [(15, "red"), (45, "brown"), (70, "yellow"), (170, "green"), (255, "blue"), (330, "purple"), (360, "red")]


def words_of(name):
    """The words of a name such as "PostTopLamp" or "stand_of_apple_0", in small letters."""
    plain = NUMBERS.sub("", name).replace("_", " ")
    return re.sub(r"(?<=[a-z])(?=[A-Z])", " ", plain).lower()


def sentence(words):
    return words[:1].upper() + words[1:]


def name_of_copy(name, facts):
    """The name of a plant, a lamp or a thing: what it is, and the name of its street or house."""
    words = words_of(name)
    kind = words.removeprefix("stand of ")
    plural = {"bush": "bushes"}.get(kind, f"{kind}s")
    if kind in TREES:
        words, plural = f"{kind} tree", f"{kind} trees"
    if kind != words_of(name):
        words = f"group of {plural}"
    place = facts.get("name") or facts.get("of_name")
    return sentence(words) + (f", {place}" if place else "")


def name_of_building(facts):
    """Its name, or its address, or its class."""
    tags = facts.get("tags") or {}
    kind = sentence(words_of(facts.get("class") or "building"))
    address = " ".join(filter(None, (tags.get("addr:street"), tags.get("addr:housenumber")))) if isinstance(tags, dict) else ""
    place = facts.get("name") or address
    return f"{kind}, {place}" if place else kind


def name_of_material(name, mesh_name):
    """The name of a material for people, with its colour if it has one of its own, and for leaves with their plant.
    @param mesh_name  Of the first mesh that shows it."""
    plain = OF_TILE.sub("", name)
    colour = COLOUR.search(plain)
    words = words_of(COLOUR.sub("", plain))
    plant = words_of(mesh_name).removeprefix("stand of ")
    if words in LEAVES:
        return f"{LEAVES[words]} of {plant}"
    for end, after in (" untextured", ", plain"), (" marked", ", marked"), (" facade atlas", ", facades"):
        words = words.removesuffix(end) + (after if words.endswith(end) else "")
    return sentence(words) + (f", {colour_word(colour[1])}" if colour else "")


def colour_word(text):
    """A word for a colour. @param text  Six hexadecimal digits of red, green and blue, as on a screen."""
    hue, saturation, value = colorsys.rgb_to_hsv(*(int(text[i:i + 2], 16) / 255 for i in (0, 2, 4)))
    if saturation < 0.25:
        return next(word for end, word in ((0.12, "black"), (0.4, "dark grey"), (0.75, "grey"), (2, "white")) if value < end)
    word = next(word for end, word in HUES if 360 * hue <= end)
    return f"dark {word}" if value < 0.35 else word
