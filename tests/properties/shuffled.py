#!/usr/bin/env python3
"""Writes an .osm file with its elements in a random order: shuffled.py IN.osm OUT.osm SEED. Node references keep their order."""
import random
import sys
import xml.etree.ElementTree as ElementTree


def shuffle(source, target, seed):
    tree = ElementTree.parse(source)
    root = tree.getroot()
    elements = [e for e in root if e.tag in ("node", "way", "relation")]
    others = [e for e in root if e.tag not in ("node", "way", "relation")]
    random.Random(seed).shuffle(elements)
    root[:] = others + elements
    tree.write(target, encoding="utf-8", xml_declaration=True)


if __name__ == "__main__":
    shuffle(sys.argv[1], sys.argv[2], int(sys.argv[3]))
