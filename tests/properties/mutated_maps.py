"""Maps with mistakes: a map's XML, and random changes of it."""
import random
import xml.etree.ElementTree as ElementTree

JUNK = ["", "0", "-1", "-0.0", "1e308", "nan", "yes", "no", "99999999999999999999", "7;8", ";", "12'6\"", "☃", "\u202e7 m", "x" * 255, "|||", "true",
        "0x10", "1e-320", "-5000", "left|right", "both", "mini"]
KEYS = ["highway", "railway", "waterway", "building", "building:part", "building:levels", "height", "min_height", "building:min_level", "roof:shape",
        "roof:height", "roof:angle", "roof:levels", "layer", "bridge", "tunnel", "width", "lanes", "oneway", "natural", "landuse", "barrier", "type",
        "junction", "sidewalk", "parking:both", "cycleway", "surface", "covered", "man_made", "power", "placement", "turn:lanes", "ele", "rack"]
VALUES = {"highway": ["residential", "motorway", "steps", "footway", "street_lamp"], "railway": ["rail", "tram", "funicular"],
          "waterway": ["river", "stream", "dam"], "building": ["yes", "roof", "church"], "natural": ["water", "wood", "tree", "coastline", "tree_row"],
          "landuse": ["forest", "orchard", "grass"], "barrier": ["wall", "hedge", "fence"], "roof:shape": ["gabled", "dome", "hipped", "skillion"],
          "type": ["multipolygon", "building"], "bridge": ["yes"], "tunnel": ["yes", "culvert"], "layer": ["-1", "1", "5"],
          "junction": ["roundabout"], "height": ["3", "300"], "building:levels": ["1", "80"], "min_height": ["2", "50"]}


def made_map(seed):
    """A few streets, houses, trees, walls, a stream and a lake, in half a square kilometre at most."""
    dice = random.Random(seed)
    nodes, ways, relations = [], [], []

    def node(x, y, tags=None):
        nodes.append((len(nodes) + 1, 47.0 + y / 111200, 9.0 + x / 75900, tags or {}))
        return len(nodes)

    def way(refs, tags):
        ways.append((len(ways) + 1, refs, tags))
        return len(ways)

    def ring(x, y, a, b):
        refs = [node(x, y), node(x + a, y), node(x + a, y + b), node(x, y + b)]
        return refs + refs[:1]

    grid = {(i, j): node(i * 70, j * 60) for i in range(4) for j in range(4)}
    for k in range(4):
        middle = dice.randrange(1, 3)
        kind = dice.choice(["residential", "primary", "footway", "service", "tertiary"])
        way([grid[i, k] for i in range(middle + 1)], {"highway": kind, "lanes": dice.choice(["1", "2", "3"])})
        way([grid[i, k] for i in range(middle, 4)], dice.choice([{"highway": kind, "bridge": "yes", "layer": "1"}, {"highway": kind},
                                                                   {"highway": kind, "tunnel": "yes", "layer": "-1"}]))
        way([grid[k, j] for j in range(4)], {dice.choice(["highway", "highway", "railway"]): dice.choice(["residential", "rail", "steps", "track"])})
    for i in range(12):
        shape = ring(dice.uniform(0, 190), dice.uniform(0, 160), dice.uniform(6, 30), dice.uniform(6, 20))
        way(shape, {dice.choice(["building", "building", "building:part"]): "yes", "building:levels": str(dice.randrange(1, 12)),
                    "roof:shape": dice.choice(["gabled", "hipped", "flat", "dome"])})
    outer, inner = way(ring(20, 65, 46, 40), {}), way(ring(30, 75, 12, 9), {})
    relations.append((1, [(outer, "outer"), (inner, "inner")], {"type": "multipolygon", "natural": dice.choice(["water", "wood"])}))
    way([node(-5, 100), node(90, 95), node(215, 130)], {"waterway": "stream"})
    way([node(5, 8), node(60, 5), node(66, 52)], {"barrier": "wall"})
    for i in range(10):
        node(dice.uniform(0, 210), dice.uniform(0, 180), {"natural": "tree"})
    return map_xml(nodes, ways, relations)


def map_xml(nodes, ways, relations, bounds=(46.9999, 8.9999, 47.0017, 9.0029)):
    """The map with a box: its least latitude and longitude, then its greatest."""
    root = ElementTree.Element("osm", version="0.6")
    ElementTree.SubElement(root, "bounds", **{name: str(value) for name, value in zip(("minlat", "minlon", "maxlat", "maxlon"), bounds)})

    def tagged(element, tags):
        for key, value in tags.items():
            ElementTree.SubElement(element, "tag", k=key, v=value)

    for number, lat, lon, tags in nodes:
        tagged(ElementTree.SubElement(root, "node", id=str(number), version="1", lat=f"{lat:.7f}", lon=f"{lon:.7f}"), tags)
    for number, refs, tags in ways:
        element = ElementTree.SubElement(root, "way", id=str(number), version="1")
        for ref in refs:
            ElementTree.SubElement(element, "nd", ref=str(ref))
        tagged(element, tags)
    for number, members, tags in relations:
        element = ElementTree.SubElement(root, "relation", id=str(number), version="1")
        for ref, role, *kind in members:
            ElementTree.SubElement(element, "member", type=kind[0] if kind else "way", ref=str(ref), role=role)
        tagged(element, tags)
    return ElementTree.tostring(root, encoding="utf-8", xml_declaration=True)


def change_tag(root, dice):
    tags = list(root.iter("tag"))
    if tags:
        tag = dice.choice(tags)
        tag.set(dice.choice(["v", "v", "v", "k"]), dice.choice(JUNK + KEYS))


def add_tag(root, dice):
    key = dice.choice(KEYS)
    element = dice.choice([e for e in root if e.tag in ("node", "way", "relation")])
    ElementTree.SubElement(element, "tag", k=key, v=dice.choice(VALUES.get(key, []) * 3 + JUNK))


def move_node(root, dice):
    nodes = [e for e in root if e.tag == "node"]
    if nodes:
        node, by = dice.choice(nodes), 10 ** dice.uniform(-7, 1)
        for axis, most in (("lat", 89), ("lon", 179)):
            node.set(axis, f"{max(-most, min(most, float(node.get(axis)) + dice.choice([-by, 0, by]))):.7f}")


def swap_references(root, dice):
    refs = list(root.iter("nd")) + list(root.iter("member"))
    if len(refs) > 1:
        a, b = dice.sample(refs, 2)
        first = a.get("ref")
        a.set("ref", b.get("ref"))
        if dice.random() < 0.7:
            b.set("ref", first)


def drop_or_repeat(root, dice):
    parents = [e for e in root if len(e)]
    if parents:
        parent = dice.choice(parents)
        child = dice.choice(list(parent))
        if dice.random() < 0.5:
            parent.remove(child)
        else:
            parent.insert(dice.randrange(len(parent) + 1), child)


CHANGES = [change_tag, change_tag, add_tag, add_tag, move_node, move_node, swap_references, drop_or_repeat]


def flip_bytes(data, dice):
    data = bytearray(data)
    for _ in range(dice.randrange(1, 4)):
        data[dice.randrange(len(data))] ^= 1 << dice.randrange(8)
    return bytes(data)


def mutated(data, seed):
    """The map with 1 to 12 random changes; one map in eight has flipped bytes instead."""
    dice = random.Random(seed)
    if dice.random() < 1 / 8:
        return flip_bytes(data, dice)
    root = ElementTree.fromstring(data)
    for _ in range(dice.randrange(1, 13)):
        dice.choice(CHANGES)(root, dice)
    return ElementTree.tostring(root, encoding="utf-8", xml_declaration=True)
