"""The budget's table: reads, writes and compares it, and says which rise needs which argument.

table.tsv has a row for each figure: map, output, level, item, value. Its first line names the item under Bytes in
CHANGELOG.md that argues for the last change.
"""
import re
from pathlib import Path

FOLDER = Path(__file__).resolve().parent
TABLE = FOLDER / "table.tsv"
CHANGELOG = FOLDER.parents[1] / "CHANGELOG.md"
ARGUED = "# changelog: "
# Instructions differ a little between machines and libraries; every other figure is exact.
RELATIVE = {"instructions": 0.03}
LARGEST_RISE = 0.10
# A row below this share of the largest value of its kind (map, output, item's first word) may rise by any factor up to it.
SMALL_SHARE = 0.01


def parse(text):
    """The rows of a table and its item of the changelog."""
    first, _, *lines = text.splitlines()
    rows = {}
    for line in lines:
        *key, value = line.split("\t")
        rows[tuple(key)] = float(value) if "." in value else int(value)
    return rows, first.removeprefix(ARGUED)


def printed(rows, argued):
    lines = [ARGUED + argued, "map\toutput\tlevel\titem\tvalue"]
    lines += ["\t".join((*key, str(value))) for key, value in rows.items()]
    return "\n".join(lines) + "\n"


def items_of_bytes(changelog):
    """The first line of each item under the headings Bytes, the newest first."""
    sections = re.findall(r"^### Bytes\n(.*?)(?=^##|\Z)", changelog, re.MULTILINE | re.DOTALL)
    return [line[2:].strip() for section in sections for line in section.splitlines() if line.startswith("- ")]


def differs(key, old, new):
    if old is None or new is None:
        return True
    allowed = RELATIVE.get(key[-1], 0)
    return abs(new - old) > allowed * old if allowed else new != old


def differences(table, found):
    """The keys whose values differ, in the order of the tables."""
    keys = [*table, *(key for key in found if key not in table)]
    return [key for key in keys if differs(key, table.get(key), found.get(key))]


def ratio_of(old, new):
    return "" if not old or new is None else f"{new / old:.3f}"


def side_by_side(table, found, keys, names=("table", "now")):
    """The rows of the keys as Markdown: old value, new value, ratio."""
    lines = [f"| map | output | level | item | {names[0]} | {names[1]} | ratio |", "|---|---|---|---|--:|--:|--:|"]
    for key in keys:
        old, new = table.get(key), found.get(key)
        shown = ["–" if value is None else f"{value:,}" for value in (old, new)]
        lines.append("| " + " | ".join((*key, *shown, ratio_of(old, new))) + " |")
    return "\n".join(lines)


def whole_comparison(table, found):
    """Returns the rows that differ, then the other rows of their maps, as Markdown."""
    changed = differences(table, found)
    maps = {key[0] for key in changed}
    others = [key for key in [*table, *found] if key[0] in maps and key not in changed]
    return (f"rows that differ: {len(changed)}\n" + side_by_side(table, found, changed) +
            "\n\nthe other rows of these maps:\n" + side_by_side(table, found, dict.fromkeys(others)))


def kind_of(key):
    return key[0], key[1], key[3].split()[0]


def rises(base, found):
    """Returns the keys of rows more than 10 % above the base and above 1 % of the largest of their kind."""
    largest = {}
    for key, value in base.items():
        largest[kind_of(key)] = max(largest.get(kind_of(key), 0), value)
    too_high = []
    for key, new in found.items():
        old = base.get(key, 0)
        floor = SMALL_SHARE * largest.get(kind_of(key), 0)
        # a row of a new map, output or kind has nothing to be compared with
        if kind_of(key) in largest and new > max(old * (1 + LARGEST_RISE), floor):
            too_high.append(key)
    return too_high
