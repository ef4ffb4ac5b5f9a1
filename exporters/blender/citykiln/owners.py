"""Tells an object of the map from what stands at it: a tree of a yard has the house's row in the table. Does not need Blender."""
from .names import words_of

# facts of the house or street that say nothing about a plant or a thing there
LEFT_OUT = {"height_m", "tags", "assumed"}
SAME = "feature"


def own_facts(name, facts):
    """The facts of a plant, a lamp or a thing: its own if it is mapped, else those that say where it stands, as of_osm_id and so on."""
    if is_mapped(name, facts):
        return facts
    return {key if key == SAME else f"of_{key}": value for key, value in facts.items() if key not in LEFT_OUT}


def is_mapped(name, facts):
    """Whether a copy shows the element of its row itself: plants and things are nodes, or have their name as class."""
    return facts.get("osm_type", "node") == "node" or words_of(facts.get("class", "")) == words_of(name)
