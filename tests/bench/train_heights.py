#!/usr/bin/env python3
"""Fits the table of storeys of compiler/assume/heights.cpp to tagged buildings, and measures it. By hand:

    tests/bench/train_heights.py FOLDER_OF_EXTRACTS [--write]

FOLDER_OF_EXTRACTS holds the extracts of building_data.PLACES, which also says what is needed. Prints the errors of three guesses: a constant by
class, the mean of tagged neighbours, and the table, in two tests: a whole place left out, and blocks of 150 m left out of a place. With --write,
writes compiler/assume/storeys.inc, fitted to all places.

The table is a decision tree over few bands (CART, Breiman et al. 1984) that minimises the error of the logarithm of the storeys, so that the
values of its leaves are medians. Each place weighs as the square root of its buildings. Buildings whose class is tagged count a second time
without it, with less weight, since most maps say building=yes.
"""
import argparse
import collections
import itertools
import math

import building_data as data

# classes whose storeys are assumed; the others keep the heights of building_classes.inc
CLASSES = ("kPlain", "kHouse", "kApartments", "kOffice", "kShop", "kHall", "kBarn", "kCivic", "kHotel", "kSchool", "kHospital")
GROUPS = ("kCentralEurope", "kSouthernEurope", "kBritishIsles", "kNorthAmerica", "kJapan")
# measured_group() of heights.cpp: groups with too few tagged buildings of their own
MEASURED_GROUP = {"kNorthernEurope": "kCentralEurope"}
USES = ("kNoUse", "kHomes", "kTrade", "kIndustry", "kCountry")
SETS = {"cls": CLASSES, "group": GROUPS, "use": USES}
BANDS = {
    "area": (20, 30, 40, 55, 70, 90, 115, 150, 200, 260, 350, 500, 700, 1000, 1500, 2500),
    "touching": (1, 2),
    "built": (0.05, 0.08, 0.11, 0.14, 0.17, 0.20, 0.24, 0.28, 0.32, 0.37, 0.42, 0.48, 0.55),
    "mean_area": (40, 60, 80, 100, 130, 160, 200, 250, 320, 400, 550, 800, 1200),
    "shops": (1, 3, 6, 12, 25),
    "row_share": (0.1, 0.25, 0.5, 0.75, 0.9),
}
FEATURES = [*SETS, *BANDS]
LEAVES = 24
# the least buildings on either side of a split, and the least places that have kFew of them, so that no leaf describes a single place
LEAST, LEAST_PLACES, FEW = 25, 3, 4
MOST_STOREYS = 60
FORGOTTEN = 0.15  # weight of a building whose class is left out


def storey_m(b):
    return data.STOREY_M[b.cls]


def roof_m(b):
    """The roof that a tagged height includes: that of single houses is pitched."""
    return 2 if not b.mates and 40 <= b.area <= 350 and b.cls in ("kHouse", "kPlain", "kApartments") else 0


def total_m(b, storeys):
    return storeys * storey_m(b) + (roof_m(b) if b.height_m else 0)


def true_m(b):
    return b.height_m or b.levels * storey_m(b)


def true_storeys(b):
    s = b.levels if b.levels and not b.height_m else (b.height_m - roof_m(b)) / storey_m(b)
    return int(max(1, min(MOST_STOREYS, math.floor(s + 0.5))))


def codes_of(b, cls=None):
    codes = []
    for name in FEATURES:
        if name in SETS:
            value = cls if name == "cls" and cls else getattr(b, name)
            codes.append(SETS[name].index(MEASURED_GROUP.get(value, value)))
        else:
            codes.append(sum(1 for band in BANDS[name] if getattr(b, name) >= band))
    return codes


LOG = [0] + [math.log(s) for s in range(1, MOST_STOREYS + 1)]


def weighted_quantile(pairs, share):
    """The value at a share of the weight of (value, weight)."""
    pairs = sorted(pairs)
    rest = share * sum(w for _, w in pairs)
    for value, weight in pairs:
        rest -= weight
        if rest <= 0:
            return value
    return pairs[-1][0]


def cost(hist):
    """The sum of absolute errors of the logarithm about the median."""
    total = sum(hist)
    if total <= 0:
        return 0
    run, median = 0, 1
    for s, w in enumerate(hist):
        run += w
        if run * 2 >= total:
            median = s
            break
    m = LOG[median]
    return sum(w * abs(LOG[s] - m) for s, w in enumerate(hist) if w)


class Node:
    pass


def node_of(samples):
    n = Node()
    n.samples, n.split = samples, None
    n.hist = [0.0] * (MOST_STOREYS + 1)
    for s in samples:
        n.hist[s[1]] += s[2]
    n.cost, n.count = cost(n.hist), len(samples)
    n.best = best_split(n)
    return n


def is_enough(counts):
    """True if so many buildings of so many places make a leaf of their own."""
    return sum(counts.values()) >= LEAST and sum(1 for n in counts.values() if n >= FEW) >= LEAST_PLACES


def best_split(node):
    """(gain, feature, codes that go left) of the best split, or None."""
    best = None
    for f, name in enumerate(FEATURES):
        by_code = collections.defaultdict(lambda: [0.0] * (MOST_STOREYS + 1))
        counts = collections.defaultdict(collections.Counter)
        for codes, storeys, weight, place in node.samples:
            by_code[codes[f]][storeys] += weight
            counts[codes[f]][place] += 1
        order = sorted(by_code)
        if name in SETS:
            order.sort(key=lambda c: sum(w * LOG[s] for s, w in enumerate(by_code[c])) / sum(by_code[c]))
        left, count, rest = [0.0] * (MOST_STOREYS + 1), collections.Counter(), sum(counts.values(), collections.Counter())
        for i, code in enumerate(order[:-1]):
            left = [a + b for a, b in zip(left, by_code[code])]
            count += counts[code]
            rest = rest - counts[code]
            if not (is_enough(count) and is_enough(rest)):
                continue
            gain = node.cost - cost(left) - cost([a - b for a, b in zip(node.hist, left)])
            if best is None or gain > best[0]:
                best = gain, f, frozenset(order[:i + 1])
    return best


# Surveys of dwellings on single houses: group, built share, mean area about, touching, areas, storeys and their shares in percent.
# Each counts as PUBLISHED places of its own. Sources: American Housing Survey and Survey of Construction (U.S. Census Bureau: about half of the
# single-family houses have one storey, 2 % three), Housing and Land Survey of Japan 2018 (detached houses: 2 storeys or more nine in ten),
# TABULA typologies (single-family houses of one to two storeys in Central, Northern and Southern Europe), English Housing Survey (houses of two
# storeys, bungalows one in ten).
PUBLISHED = (
    ("kNorthAmerica", 0.20, 180, 0, (130, 180, 240, 320), ((1, 58), (2, 40), (3, 2))),
    ("kJapan", 0.30, 80, 0, (45, 60, 80, 100, 140), ((1, 10), (2, 82), (3, 8))),
    ("kJapan", 0.40, 70, 0, (45, 60, 80, 100, 140), ((1, 10), (2, 82), (3, 8))),
    ("kCentralEurope", 0.14, 110, 0, (75, 95, 120, 160), ((1, 45), (2, 52), (3, 3))),
    ("kNorthernEurope", 0.12, 120, 0, (75, 95, 120, 160), ((1, 50), (2, 48), (3, 2))),
    ("kSouthernEurope", 0.14, 120, 0, (75, 95, 120, 160), ((1, 35), (2, 55), (3, 10))),
    ("kBritishIsles", 0.16, 80, 1, (45, 60, 80, 110), ((1, 10), (2, 85), (3, 5))),
)
PUBLISHED_WEIGHT = 10.0


def published_samples():
    """The rows of PUBLISHED as samples of houses, and of buildings of unknown class on residential land."""
    samples = []
    for i, (group, built, mean_area, touching, areas, storeys) in enumerate(PUBLISHED):
        for area, cls, row_share in itertools.product(areas, ("kHouse", "kPlain"), (0.9,) if touching else (0, 0.1) if group == "kJapan" else (0.1,)):
            b = data.Building()
            b.cls, b.group, b.use, b.area, b.touching, b.built, b.mean_area = cls, group, "kHomes", area, touching, built, mean_area
            b.shops, b.row_share = 0, row_share
            weight = PUBLISHED_WEIGHT / len(areas)
            samples += [(codes_of(b), s, weight * percent / 100, f"published {i} {k}") for k in range(3) for s, percent in storeys]
    return samples


def fit(buildings):
    """The root of a tree."""
    places = collections.Counter(b.place for b in buildings)
    samples = []
    for b in buildings:
        weight = places[b.place] ** -0.5
        samples.append((codes_of(b), true_storeys(b), weight, b.place))
        if b.cls != "kPlain":
            samples.append((codes_of(b, "kPlain"), true_storeys(b), FORGOTTEN * weight, b.place))
    samples += published_samples()
    root = node_of(samples)
    leaves = [root]
    while len(leaves) < LEAVES:
        leaf = max((n for n in leaves if n.best), key=lambda n: n.best[0], default=None)
        if leaf is None or leaf.best[0] <= 0:
            break
        _, f, codes = leaf.best
        leaf.split = f, codes
        # a code that no building of the leaf has goes with the larger side
        leaf.left = node_of([s for s in leaf.samples if s[0][f] in codes])
        leaf.right = node_of([s for s in leaf.samples if s[0][f] not in codes])
        leaves.remove(leaf)
        leaves += [leaf.left, leaf.right]
    seal(root)
    return root


def seal(node):
    """Completes splits of bands to thresholds, and sets of classes to all; computes the values of leaves."""
    if node.split is None:
        pairs = [(s[1], s[2]) for s in node.samples]
        node.quartiles = [weighted_quantile(pairs, q) for q in (0.25, 0.5, 0.75)]
        return
    f, codes = node.split
    name = FEATURES[f]
    if name in SETS:
        heavier = sum(node.left.hist) > sum(node.right.hist)
        seen = {s[0][f] for s in node.samples}
        codes = frozenset(c for c in range(len(SETS[name])) if c in codes or (c not in seen and heavier))
    else:
        codes = frozenset(range(max(codes) + 1))
    node.split = f, codes
    seal(node.left)
    seal(node.right)


def leaf_of(root, b):
    codes, node = codes_of(b), root
    while node.split:
        node = node.left if codes[node.split[0]] in node.split[1] else node.right
    return node


# ---- blending with tagged neighbours --------------------------------------------------------------------------------
# as in heights.cpp
NEIGHBOURS_M, TABLE, HALF_M, OTHER_CLASS, TOUCHING = 200, 0.3, 60, 0.4, 2


def likeness(b, o):
    """The weight of a tagged neighbour: by distance, class, size, and whether the two touch."""
    far = math.dist(b.at, o.at) / HALF_M
    size = min(b.area, o.area) / max(b.area, o.area)
    return size * (1 if b.cls == o.cls else OTHER_CLASS) * (TOUCHING if o in b.mates else 1) / (1 + far * far)


def guess(b, table, neighbours):
    """Quartiles of the storeys, blended."""
    votes = [(table[0], 0.3 * TABLE), (table[1], 0.4 * TABLE), (table[2], 0.3 * TABLE)] + [(o.storeys, likeness(b, o)) for o in neighbours]
    return [weighted_quantile(votes, q) for q in (0.25, 0.5, 0.75)]


# ---- measuring ------------------------------------------------------------------------------------------------------
def by_class(buildings):
    heights = collections.defaultdict(list)
    places = collections.Counter(b.place for b in buildings)
    for b in buildings:
        heights[b.cls].append((true_m(b), places[b.place] ** -0.5))
        heights[None].append((true_m(b), places[b.place] ** -0.5))
    return {cls: weighted_quantile(pairs, 0.5) for cls, pairs in heights.items() if cls is None or len(pairs) >= 10}


def quantile(values, share):
    values = sorted(values)
    return values[min(len(values) - 1, int(len(values) * share))] if values else float("nan")


def tagged(buildings):
    return [b for b in buildings if (b.levels or b.height_m) and b.cls in CLASSES]


def block(b):
    return math.floor(b.at[0] / 150), math.floor(b.at[1] / 150)


def neighbours_of(b, grid, own_block):
    return [o for o in grid.about(data.about(b.at, NEIGHBOURS_M))
            if o is not b and own_block != block(o) and math.dist(o.at, b.at) <= NEIGHBOURS_M]


def errors_of(place, known, root, constants):
    """By test and guess: absolute errors in metres."""
    rows = collections.defaultdict(list)
    grid = data.Grid(100)
    for b in known:
        b.storeys = true_storeys(b)
        grid.add(data.about(b.at, 0), b)
    for b in known:
        truth, constant = true_m(b), constants.get(b.cls, constants[None])
        own = leaf_of(root, b).quartiles
        near = neighbours_of(b, grid, block(b))
        mean = sum(true_m(o) for o in near) / len(near) if near else constant
        blended = guess(b, own, near)
        rows["today"].append(abs(today_m(b) - truth))
        rows["constant"].append(abs(constant - truth))
        rows["table"].append(abs(total_m(b, own[1]) - truth))
        rows["mean"].append(abs(mean - truth))
        rows["blended"].append(abs(total_m(b, blended[1]) - truth))
        rows["drawn"] += [abs(total_m(b, own[k]) - truth) for k in (0, 1, 1, 2)]
        rows["blended drawn"] += [abs(total_m(b, blended[k]) - truth) for k in (0, 1, 1, 2)]
    return rows


def today_m(b):
    m = data.CLASS_HEIGHT_M[b.cls]
    if m == 0:
        m = 2.8 if b.area < 25 else 4.5 if b.area < 70 else 7.5 if b.area < 220 else 11 if b.area < 700 else 13
    return m + (roof_m(b) if b.height_m else 0)


GUESSES = ("today", "constant", "table", "drawn", "mean", "blended", "blended drawn")


def print_row(name, rows):
    cells = "".join(f"{quantile(rows[g], 0.5):9.1f} {quantile(rows[g], 0.9):5.1f}" for g in GUESSES)
    print(f"{name:15}{len(rows['table']):6}{cells}", flush=True)


def measure(places):
    print(f"{'place':15}{'count':>6}" + "".join(f"{g:>15}" for g in GUESSES) + "   (median and 90th percentile, m)")
    pooled = collections.defaultdict(list)
    for place, known in places.items():
        if len(known) < 40:
            continue
        rest = [b for other, bs in places.items() if other != place for b in bs]
        rows = errors_of(place, known, fit(rest), by_class(rest))
        for g in GUESSES:
            pooled[g] += rows[g]
        print_row(place, rows)
    print_row("pooled", pooled)


# ---- writing --------------------------------------------------------------------------------------------------------
def leaves_of(node, limits):
    """(limits by feature, leaf) of all leaves; limits are sets of codes."""
    if node.split is None:
        yield limits, node
        return
    f, codes = node.split
    everything = frozenset(range(len(SETS[FEATURES[f]]) if FEATURES[f] in SETS else len(BANDS[FEATURES[f]]) + 1))
    held = limits.get(f, everything)
    yield from leaves_of(node.left, {**limits, f: held & codes})
    yield from leaves_of(node.right, {**limits, f: held - codes})


def conditions(limits):
    """The limits of a leaf as initializers of StoreyConditions (heights.cpp)."""
    parts, short = [], {"cls": "classes", "group": "groups", "use": "uses"}
    for f, name in enumerate(FEATURES):
        codes = limits.get(f)
        if codes is None:
            continue
        if name in SETS:
            if len(codes) < len(SETS[name]):
                parts.append(f".{short[name]} = " + " | ".join(SETS[name][c] for c in sorted(codes)))
            continue
        if min(codes) > 0:
            parts.append(f".{name}_from = {BANDS[name][min(codes) - 1]:g}")
        if max(codes) < len(BANDS[name]):
            parts.append(f".{name}_to = {BANDS[name][max(codes)]:g}")
    return ", ".join(parts)


def write(root):
    rows = []
    for limits, leaf in leaves_of(root, {}):
        real = [s for s in leaf.samples if not s[3].startswith("published")]
        low, middle, high = leaf.quartiles
        text = conditions(limits)
        rows.append(((middle, high, low), f"STOREYS({low}, {middle}, {high}, {len(real)}, {len({s[3] for s in real})}, {text})"))
    path = data.ROOM / "assume" / "storeys.inc"
    path.write_text(HEADER + "\n".join(row for _, row in sorted(rows)) + "\n")


HEADER = """// Written by tests/bench/train_heights.py: do not edit.
// STOREYS(lower quartile, median, upper quartile of the storeys, tagged buildings behind the row, their places, conditions…): storeys of buildings,
// measured on the tagged buildings of the places that assumptions.md lists, and for single houses on surveys of dwellings. The rows do not
// overlap. area, mean_area: m²; touching, shops: counts; built, row_share: shares. Conditions that are not named hold for all.
"""


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder")
    parser.add_argument("--write", action="store_true")
    args = parser.parse_args()
    places = {place: tagged(data.read(args.folder, place)) for place in data.PLACES}
    measure(places)
    if args.write:
        write(fit([b for known in places.values() for b in known]))


if __name__ == "__main__":
    main()
