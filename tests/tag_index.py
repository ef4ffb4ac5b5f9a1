#!/usr/bin/env python3
"""Makes compiler/map/tags.md, the index of the keys of OSM tags that the program reads and of the files that read them.

Run without arguments, it prints the page; with --update, it writes the page. A key is a literal in one of these places:

- the argument of a function whose parameter is named `key` (tagged_length_m(…, "height", …)), or of one in KEY_ARGUMENTS
- the first column of a table whose macro or struct names its first member `key` (AREA("natural", …), PointRow{"shop", …})
- the values of a loop variable named `key`
- the tests of tags and the lengths in the table of things
"""
import os
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PAGE = ROOT / "compiler/map/tags.md"
ROOMS = ["compiler/source", "compiler/map", "compiler/regions"]
THINGS = Path("grammars/things/things.txt")
# The keys of options of heightmaps.
NO_TAGS = ["compiler/source/raster_spec.cpp"]
WIDEST_PAGE = 120

# Functions of libraries, operators and functions with other names of parameters: the positions of keys in a call.
KEY_ARGUMENTS = {"has_key": [0], "has_tag": [0], "get_value_by_key": [0], "tags": [0], "(*this)": [0],
                 "tagged_colour": [3, 4], "tagged_of": [0, 1]}
# Functions that append to a key, with the keys that they read.
ALONG = ["{}", "{}:<direction>"]
EXPANDED = {"beside": ["{}:<side>"], "width_beside": ["{}:<side>:width"], "is_beside": ["{}", "{}:<side>"],
            "key_along": ALONG, "list_along": ALONG}
# Structs whose rows are keys for such a function.
EXPANDED_ROWS = {"ListRow": ALONG}
# Expressions by which a lookup gets a key that another rule finds.
KNOWN_EXPRESSIONS = {"key", "row.key", "full", "directed", "key_along(flow, key)", "lumen_key", "kEntrance.key", "kAddress.key",
                     "key + std::string(tags.suffix(other))", "british", 'tagged_of("lamp_type", "light:method")',
                     "std::string(key).c_str()", "std::string(prefix.text).append(key)", "row.value", "each.key", "std::string(row.key).c_str()"}

STRING = r'"((?:[^"\\]|\\.)*)"'
KEY_PARAMETER = re.compile(r"(std::string_view|const std::string&|const char\*) key")
KEY_OF_MACRO = re.compile(r"key")
LITERAL = re.compile(rf"^{STRING}$")
SUFFIXED = re.compile(rf"^{STRING} \+ (?:std::string\(tags\.suffix\(\w+\)\)|suffix)$")


def without_comments(text):
    return re.sub(rf"{STRING}|//[^\n]*", lambda found: found[0] if found[0].startswith('"') else "", text)


def sources():
    """Path and text, without comments, of each source of the rooms that read tags."""
    for room in ROOMS:
        for path in sorted((ROOT / room).rglob("*")):
            name = path.relative_to(ROOT)
            if path.suffix in (".h", ".cpp", ".inc") and str(name) not in NO_TAGS:
                yield name, without_comments(path.read_text(encoding="utf-8"))


def arguments_at(text, opening):
    """The arguments between the bracket at `opening` and its partner, each with single spaces."""
    arguments, depth, begin, at = [], 0, opening + 1, opening
    while at < len(text):
        if text[at] == '"':
            at = re.compile(STRING).match(text, at).end()
            continue
        if text[at] in "([{":
            depth += 1
        elif text[at] in ")]}":
            depth -= 1
        if (text[at] == "," and depth == 1) or depth == 0:
            arguments.append(" ".join(text[begin:at].split()))
            begin = at + 1
        if depth == 0:
            return arguments
        at += 1
    return arguments


def parameters_named_key(texts):
    """For each function or macro with a parameter `key`, the positions of it."""
    positions = {name: list(at) for name, at in KEY_ARGUMENTS.items()}
    for text in texts:
        for found in re.finditer(r"(#define )?\b(\w+)\((?=[^{};]*\bkey\b)", text):
            is_key = KEY_OF_MACRO if found[1] else KEY_PARAMETER
            for i, parameter in enumerate(arguments_at(text, found.end() - 1)):
                if is_key.fullmatch(parameter) and i not in positions.setdefault(found[2], []):
                    positions[found[2]].append(i)
    return {name: at for name, at in positions.items() if at}


def expanded(name, key, arguments):
    """The keys that a call of a function reads."""
    if name == "beside" and len(arguments) > 2:
        suffix = LITERAL.match(arguments[2])
        return [f"{key}:<side>{suffix[1] if suffix else ':<value>'}"]
    return [form.format(key) for form in EXPANDED.get(name, ["{}"])]


def keys_in_calls(text, positions):
    call = re.compile(r"(?<![\w])(" + "|".join(sorted(map(re.escape, positions), key=len, reverse=True)) + r")\(")
    for found in call.finditer(text):
        arguments = arguments_at(text, found.end() - 1)
        for position in positions[found[1]]:
            argument = arguments[position] if position < len(arguments) else ""
            if LITERAL.match(argument):
                yield from expanded(found[1], LITERAL.match(argument)[1], arguments)
            elif SUFFIXED.match(argument):
                yield SUFFIXED.match(argument)[1] + ":<direction>"


def literals_in(text):
    return [found[1] for found in re.finditer(STRING, text)]


def keys_in_loops(text):
    """The values of each `for (… key : …)`. A loop that appends a direction to them reads the directed keys."""
    for found in re.finditer(r"for \(const (?:std::string_view|char\*) key : (\w+|\{[^}]*\})\)(?=(.{0,120}))", text, re.DOTALL):
        values = found[1]
        if not values.startswith("{"):
            array = re.search(rf"\b{values}(?:\[\])? = (\{{[^}}]*\}})", text)
            values = array[1] if array else ""
        form = "{}:<direction>" if "key + std::string(tags.suffix(" in found[2] else "{}"
        yield from (form.format(key) for key in literals_in(values))


def keys_in_rows(text):
    """The first member of each row of a struct whose first member is `key`."""
    for struct in re.finditer(r"struct (\w+) \{\s*(?:std::string_view|const char\*) key\b", text):
        for rows in re.finditer(rf"{struct[1]} k\w+(?:\[\] = )?(\{{.*?\}});", text, re.DOTALL):
            for key in re.findall(rf"\{{{STRING},", rows[1]):
                yield from (form.format(key) for form in EXPANDED_ROWS.get(struct[1], ["{}"]))


def with_direction(key):
    """lanes:forward and lanes:backward are one row of the index."""
    return re.sub(r":(forward|backward)$", ":<direction>", key)


def keys_in(text, positions):
    found = [*keys_in_calls(text, positions), *keys_in_loops(text), *keys_in_rows(text)]
    found += re.findall(rf"strings\[\w+\.key\] [!=]= {STRING}", text)
    return {with_direction(key) for key in found}


def unexplained_lookups():
    """Lookups of a key by an expression that no rule of this script reads."""
    lookup = re.compile(r"(context\.tag|value_of|\(\*this\)|(?<![\w.)])tags|has_key|has_tag|get_value_by_key)\(")
    for path, text in sources():
        for found in lookup.finditer(text):
            arguments = arguments_at(text, found.end() - 1)
            at = 1 if found[1] in ("context.tag", "value_of") else 0
            argument = arguments[at] if at < len(arguments) else ""
            is_declaration = re.match(r"[\w:]+ \w+$", argument)
            if argument and not (LITERAL.match(argument) or SUFFIXED.match(argument) or argument in KNOWN_EXPRESSIONS or is_declaration):
                yield f"{path}: {found[0]}… {argument}"


def keys_of_things():
    """The keys of the columns "tags" and "size" of the table of things."""
    for row in (ROOT / THINGS).read_text(encoding="utf-8").splitlines():
        columns = row.partition("#")[0].split()
        if columns and columns[1] != "-":
            yield from (re.split("!?=", test)[0] for test in re.split("[&|]", columns[1]))
            yield from (length.rpartition(":")[0] for length in columns[3].split("x") if ":" in length)


def index():
    """For each key, the files that read it."""
    texts = dict(sources())
    positions = parameters_named_key(texts.values())
    readers = {}
    for path, text in texts.items():
        for key in keys_in(text, positions):
            readers.setdefault(key, []).append(path)
    for key in sorted(set(keys_of_things())):
        readers.setdefault(key, []).append(THINGS)
    return readers


def item(key, paths):
    """The lines of a key: links to its files, relative to the page."""
    lines = [f"- `{key}`:"]
    for i, path in enumerate(paths):
        link = f"[{path.stem}]({os.path.relpath(path, PAGE.parent.relative_to(ROOT))})" + ("," if i + 1 < len(paths) else "")
        if len(lines[-1]) + 1 + len(link) > WIDEST_PAGE:
            lines.append(" ")
        lines[-1] += " " + link
    return lines


def page():
    readers = index()
    lines = ["# Keys of OSM tags", "",
             "This index has the keys of tags that the program reads, each with the files that read it. It is made from the code by",
             "`python3 tests/tag_index.py --update`; `tests/tag_index_test.py` fails if it is out of date.", "",
             f"- There are {len(readers)} keys. `<side>` is `left`, `right` or `both`, `<direction>` is `forward` or `backward`, `<value>` is the",
             "  value of the key before it.",
             "- [tag_values](tags/tag_values.cpp) parses lengths, numbers, colours and dates of all keys: it knows units, spellings.",
             "- In a table (`….inc`) another value of a key is another row.",
             "- [source](../source) reads keys to assemble areas, [regions](../regions) to cut a map and to estimate costs.", ""]
    for key in sorted(readers):
        lines += item(key, readers[key])
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    if sys.argv[1:] == ["--update"]:
        PAGE.write_text(page(), encoding="utf-8")
    else:
        print(page(), end="")
