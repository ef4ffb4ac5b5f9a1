#!/usr/bin/env python3
"""Checks the source tree: which room may include which, that no folders of a room include each other in a cycle, how files
are named, and that rooms after the map use only functions that give the same bits on every machine.

Prints one line for each violation.
"""
import re
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent

CMAKE = (ROOT / "CMakeLists.txt").read_text()


def linked_rooms():
    """For each room the rooms that CMakeLists.txt links it to: citykiln_room(sky compiler/sky citykiln_map). The library
    pipeline is the sources at the top of compiler."""
    linked = {name: set(re.findall(r"citykiln_(\w+)", libraries)) for name, libraries in
              re.findall(r"^citykiln_room\((\w+) \S+ ([^)]*)\)", CMAKE, re.M)}
    pipeline = re.search(r"^target_link_libraries\(citykiln_pipeline PUBLIC (.*?) PRIVATE", CMAKE, re.M)[1]
    return {**linked, "pipeline": set(re.findall(r"citykiln_(\w+)", pipeline)), "main": {"commands"}}


LINKED = linked_rooms()


def all_linked(room):
    """The rooms that a room is linked to, directly or through others. A room may include these."""
    return set().union(*({other} | all_linked(other) for other in LINKED[room]))


ALLOWED = {room: all_linked(room) for room in LINKED}

# Headers that a room may not include although they are linked: patterns of the included path.
FORBIDDEN = {
    "exporters": r"compiler/source/|grammars/|lsystems/|compiler/[^/]+\.h$|.*/(plan|generate)\.h$",
    "preview": r"grammars/|lsystems/|compiler/source/read_|compiler/[^/]+\.h$|.*/plan\.h$",
    "main": r"(?!compiler/commands/)",
}

# Names that do not say what a file holds.
VAGUE = re.compile(r"(^|_)(util|utils|common|helper|helpers|manager|misc|core|stuff|tools?)(_|$)")

# tinygltf reads .glb files. Writers fill a JSON document, which becomes text once (exporters/gltf/glb_parts.h): these sources alone know it.
GLTF_READERS = re.compile(r"exporters/gltf/read/\w+\.(h|cpp)")
KNOWS_TINYGLTF = re.compile(r"tiny_gltf|tinygltf|TINYGLTF|gltf/read/glb_reader\.h")

# Steps of a folder: files of a folder may include their own and those of earlier rows. "" has the files at the top.
STEPS = {"exporters/gltf": [["", "pictures"], ["pack"], ["write", "read"]]}

# Functions whose last bits differ between CPUs and C libraries.
NOT_REPRODUCIBLE = re.compile(r"<random>|std::hash\b|std::(a?sinh?|a?cosh?|a?tanh?|atan2|exp2?|expm1|pow|log(2|10|1p)?|cbrt|hypot)\(")
REPRODUCIBLE_ROOMS = ["grammars", "lsystems", "compiler/edits", "compiler/parcels", "compiler/invent", "compiler/simplify", "compiler/climate"] + ["compiler/" + room for room in
                      ("map", "assume", "roads", "lots", "fields", "ground", "structures", "buildings", "plants", "props", "pitches", "things", "wires", "roadside", "cars", "furniture", "vacant", "people", "sky",
                       "surroundings")]
# sky light, which is only in rendered pictures
EXEMPT = [Path("compiler/sky") / name for name in ("generate.cpp", "spectrum.cpp", "stars.cpp", "atmosphere")]


def sources():
    for top in ("compiler", "exporters", "preview", "grammars", "lsystems"):
        for path in sorted((ROOT / top).rglob("*")):
            if path.suffix in (".h", ".cpp", ".inc"):
                yield path.relative_to(ROOT)


def room_of(path):
    if str(path) == "compiler/main.cpp":
        return "main"
    parts = path.parts
    return "/".join(parts[:2]) if parts[0] == "compiler" and len(parts) > 2 else parts[0]


def library_of(path):
    """The name of the room's library in CMakeLists.txt; roofs are one of their own."""
    if path.parts[:2] == ("grammars", "roofs"):
        return "roofs"
    room = room_of(path)
    return "pipeline" if room == "compiler" else room.split("/")[-1]


def node_of(path):
    """The node of the graph inside a room: a folder with all below it, or a file at the room's top."""
    return "/".join(path.parts[:len(Path(room_of(path)).parts) + 1])


def step_of(folder, path):
    """The folder directly in this one in which a file is, "" for files at its top, or None for files elsewhere."""
    if not path.is_relative_to(folder):
        return None
    inside = path.relative_to(folder).parts
    return inside[0] if len(inside) > 1 else ""


def quoted_includes(path):
    """Line number and path of each #include with quotes."""
    for number, line in enumerate((ROOT / path).read_text().splitlines(), 1):
        found = re.match(r'\s*#\s*include\s+"([^"]+)"', line)
        if found:
            yield number, found.group(1)


def violation_of_include(path, included):
    own, other = library_of(path), library_of(Path(included))
    if other not in ALLOWED:
        return f"{included} is in no room of CMakeLists.txt"
    if own != other and other not in ALLOWED[own]:
        return f"{own} may not include {included}: CMakeLists.txt does not link it to {other}"
    if room_of(path) != room_of(Path(included)) and re.match(FORBIDDEN.get(room_of(path), r"$^"), included):
        return f"{own} may not include {included}"
    return None


def includes_inside_rooms():
    """For each node the nodes of its room that it includes, each with the place of the first include."""
    graph = {}
    for path in sources():
        for number, included in quoted_includes(path):
            target = Path(included)
            if room_of(path) == room_of(target) and node_of(path) != node_of(target):
                graph.setdefault(node_of(path), {}).setdefault(node_of(target), f"{path}:{number}")
    return graph


def cycles_of(graph):
    """Cycles found by depth-first search, at least one if there are any; each ends with the node it starts with."""
    finished, cycles = set(), []

    def visit(node, trail):
        if node in trail:
            cycles.append(trail[trail.index(node):] + [node])
        elif node not in finished:
            for target in graph.get(node, {}):
                visit(target, trail + [node])
            finished.add(node)

    for start in graph:
        visit(start, [])
    return cycles


# Declarations start at the left margin. A type is named by the word after its kind, everything else by the last word before the
# first of ( [ { = ; and ,
LOCAL_TYPE = re.compile(r"^(?:template <.*> )?(?:struct|class|enum class|enum|union) (\w+)(?!.*;$)")
LOCAL_VALUE = re.compile(r"^(?!template\b|using\b|TEST|INSTANTIATE|namespace\b|static_assert|struct\b|enum\b|class\b)[A-Za-z][^=({;]*?[\s*&](\w+)(?:\(|\[| =|\{|;|,)")


def local_names(text):
    """The names that a source declares in anonymous namespaces, without aliases and operators."""
    is_inside = False
    for line in re.sub(r'R"(\w*)\(.*?\)\1"', '""', text, flags=re.DOTALL).splitlines():
        if line == "namespace {":
            is_inside = True
        elif re.fullmatch(r"}\s*// namespace", line):
            is_inside = False
        elif is_inside and "operator" not in line:
            found = LOCAL_TYPE.match(line) or LOCAL_VALUE.match(line)
            if found:
                yield found.group(1)


def unit_of(path):
    """The room, or folder of tests for a room, whose sources are compiled together (CITYKILN_UNITY)."""
    parts = path.parts
    depth = 1 + (parts[0] in ("compiler", "tests")) + (parts[:2] == ("tests", "compiler")) + (parts[-3:-1] == ("grammars", "roofs"))
    return "/".join(parts[:min(depth, len(parts) - 1)])


def shared_local_names():
    """Names that two sources of a unit declare in anonymous namespaces, each with its sources."""
    declared = {}
    for top in ("compiler", "exporters", "preview", "grammars", "lsystems", "tests"):
        for path in sorted((ROOT / top).rglob("*.cpp")):
            path = path.relative_to(ROOT)
            if not path.parts[-2].endswith("_module") and path.parts[:2] != ("tests", "fuzz"):
                for name in set(local_names((ROOT / path).read_text())):
                    declared.setdefault((unit_of(path), name), []).append(str(path))
    return {name: paths for name, paths in declared.items() if len(paths) > 1}


# Rooms that make a product once a run; none may change the product of another. The report is where all of them write.
STAGES = ["source", "map", "assume", "roads", "lots", "fields", "ground", "structures", "buildings", "plants", "props", "pitches", "things", "wires", "roadside", "cars", "furniture", "vacant", "people", "sky",
          "surroundings", "scene"]
# Working data that a room lends to another by reference, which is no product.
# A view is passed by value; rasters are so large that they are handed on.
LENT = {"map::FeatureView", "source::Raster"}


def declarations(text):
    """Functions that a header declares at the left margin, without comments: (name, result, parameters)."""
    code = re.sub(r"//.*", "", text)
    for found in re.finditer(r"^(?!using|typedef|#|namespace|struct|class|enum|static_assert)(?P<result>[A-Za-z][^;{}()=]*?[\s&*])(?P<name>\w+)\((?P<parameters>[^;{}]*?)\)\s*(?=[;{])",
                             code, re.M):
        yield found["name"], " ".join(found["result"].split()), split_parameters(" ".join(found["parameters"].split()))


def split_parameters(text):
    parts, depth = [""], 0
    for char in text:
        depth += (char in "<({") - (char in ">)}")
        if char == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += char
    return [part.strip() for part in parts if part.strip()]


def foreign_types(text, room):
    """The types of other stages that a declaration names, such as map::Features."""
    return {f"{space}::{name}" for space, name in re.findall(r"\b(\w+)::([A-Z]\w*)", text) if space in STAGES and space != room} - LENT


def changes_of_products(text, room):
    """Parameters by which a function can change the product of another stage: a reference that is not const, or a value
    of a type that the function also returns."""
    for name, result, parameters in declarations(text):
        for parameter in parameters:
            types = foreign_types(parameter, room)
            is_reference = re.search(r"(?<!&)&(?!&)", parameter) and not re.search(r"\bconst\b[^,]*&", parameter)
            is_value = "&" not in parameter and "*" not in parameter and "span" not in parameter and types & foreign_types(result, room)
            if types and (is_reference or is_value):
                yield f"{name}() may change {parameter}"


def edits_in_pipeline(text):
    """Lines of compile_part() that change a local again, and locals that are not const."""
    body = re.search(r"^Result<CompileResult> compile_part\(.*?^}", text, re.M | re.S)[0].split("remove_diagnoses_outside")[0]
    for line in body.splitlines()[2:]:
        line = line.split("//")[0].strip()
        if re.match(r"(?!timer\.|report\.)\w[\w.>-]* = |std::erase|std::(ranges::)?sort", line) or re.search(r"\.(push_back|insert|erase)\(", line):
            yield f"changes a product: {line}"
        if re.match(r"(?!const |return |StageTimer |Report |timer|report|if |assert|scene::Scene scene = )[a-zA-Z][\w:<>, ]*[&\s]\w+( = |\{|\()", line):
            yield f"is not const: {line}"


class Rooms(unittest.TestCase):
    def assertNone(self, violations):
        if violations:
            self.fail("\n" + "\n".join(violations))

    def test_sources_are_found(self):
        self.assertGreater(len(list(sources())), 500)
        self.assertEqual({library_of(path) for path in sources()}, set(ALLOWED))

    def test_rooms_include_linked_rooms_only(self):
        violations = []
        for path in sources():
            for number, included in quoted_includes(path):
                violation = violation_of_include(path, included)
                if violation:
                    violations.append(f"{path}:{number}: {violation}")
        self.assertNone(violations)

    def test_an_include_of_another_room_is_found(self):
        self.assertIn("does not link it to wires", violation_of_include(Path("compiler/sky/plan.cpp"), "compiler/wires/recipe.h"))
        self.assertIn("does not link it to map", violation_of_include(Path("compiler/invent/a.cpp"), "compiler/map/features.h"))
        self.assertIsNone(violation_of_include(Path("compiler/sky/plan.cpp"), "compiler/map/features.h"))

    def test_rooms_link_what_they_include_and_no_more(self):
        used = {}
        for path in sources():
            for _, included in quoted_includes(path):
                used.setdefault(library_of(path), set()).add(library_of(Path(included)))
        self.assertNone([f"{room} is linked to {other}, but does not include it" for room, others in LINKED.items()
                         for other in sorted(others - used.get(room, set()))])
        self.assertNone([f"{room} is linked to {other}, which {via} brings" for room, others in LINKED.items()
                         for other in sorted(others) for via in sorted(others) if other in ALLOWED[via]])

    def test_folders_of_a_room_do_not_include_each_other_in_a_cycle(self):
        graph = includes_inside_rooms()
        self.assertGreater(len(graph), 100)
        self.assertNone([f"cycle: {' -> '.join(cycle)}\n" +
                         "\n".join(f"    {graph[a][b]}: {a} includes {b}" for a, b in zip(cycle, cycle[1:]))
                         for cycle in cycles_of(graph)])

    def test_steps_of_a_folder_include_earlier_ones_only(self):
        violations = []
        for folder, rows in STEPS.items():
            row_of = {step: i for i, row in enumerate(rows) for step in row}
            for path in (path for path in sources() if path.is_relative_to(folder)):
                for number, included in quoted_includes(path):
                    own, other = step_of(folder, path), step_of(folder, Path(included))
                    if other is not None and own != other and row_of[other] >= row_of[own]:
                        violations.append(f"{path}:{number}: {own or 'the top'} may not include {included}")
        self.assertEqual({step_of(folder, path) for folder in STEPS for path in sources()} - {None},
                         {step for rows in STEPS.values() for row in rows for step in row})
        self.assertNone(violations)

    def test_a_cycle_is_found(self):
        self.assertEqual(cycles_of({"a": {"b": ""}, "b": {"c": ""}}), [])
        self.assertEqual(cycles_of({"a": {"b": ""}, "b": {"c": ""}, "c": {"b": ""}}), [["b", "c", "b"]])

    def test_names_in_anonymous_namespaces_are_unique_in_a_room(self):
        self.assertNone([f"{unit}: {name} is declared in {' and '.join(paths)}"
                         for (unit, name), paths in sorted(shared_local_names().items())])

    def test_local_names_are_found(self):
        text = "\n".join(["int outside();", "namespace {", "struct Piece {", "  int member;", "};", "using Ring = int;", "struct Ahead;",
                          "constexpr double kA_m = 2, kB_m = 3;", "std::vector<int> pieces_of(const Piece& piece) {", "template <typename T>",
                          "bool is_any(T t) {", "}  // namespace", "int after() {"])
        self.assertEqual(list(local_names(text)), ["Piece", "kA_m", "pieces_of", "is_any"])
        self.assertGreater(len(set(local_names((ROOT / "compiler/ground/mesh/refine.cpp").read_text()))), 3)
        self.assertEqual(unit_of(Path("tests/compiler/ground/mesh/a_test.cpp")), "tests/compiler/ground")
        self.assertEqual(unit_of(Path("compiler/ground/mesh/a.cpp")), "compiler/ground")
        self.assertEqual(unit_of(Path("grammars/roofs/a.cpp")), "grammars/roofs")

    def test_includes_name_files_from_the_root(self):
        violations = []
        for path in sources():
            for number, included in quoted_includes(path):
                if not (ROOT / included).exists() and not included.endswith("_generated.h"):
                    violations.append(f"{path}:{number}: there is no {included}")
        self.assertNone(violations)

    def test_a_source_includes_its_own_header_first(self):
        violations = []
        for path in sources():
            header = path.with_suffix(".h")
            if path.suffix != ".cpp" or not (ROOT / header).exists():
                continue
            first = next((included for _, included in quoted_includes(path)), None)
            if first != str(header):
                violations.append(f"{path}: {header} must be the first include")
        self.assertNone(violations)

    def test_headers_have_pragma_once(self):
        self.assertNone([f"{path}: #pragma once is missing" for path in sources()
                         if path.suffix == ".h" and "#pragma once" not in (ROOT / path).read_text()])

    def test_file_names_say_what_a_file_holds(self):
        violations = []
        for top in ("compiler", "exporters", "preview", "grammars", "lsystems", "tests", "examples"):
            for path in sorted((ROOT / top).rglob("*")):
                if "node_modules" not in path.parts and VAGUE.search(path.stem):
                    violations.append(f"{path.relative_to(ROOT)}: the name does not say what it holds")
        self.assertNone(violations)

    def test_rooms_after_the_map_use_reproducible_functions_only(self):
        violations = []
        for path in sources():
            if room_of(path) not in REPRODUCIBLE_ROOMS or path in EXEMPT or path.parent in EXEMPT:
                continue
            for number, line in enumerate((ROOT / path).read_text().splitlines(), 1):
                if NOT_REPRODUCIBLE.search(line.split("//")[0]):
                    violations.append(f"{path}:{number}: {line.strip()}")
        self.assertNone(violations)

    def test_tinygltf_only_reads(self):
        code = {path: re.sub(r"//.*", "", (ROOT / path).read_text()) for path in sources()}
        known_by = {path for path in code if KNOWS_TINYGLTF.search(code[path])}
        readers = {path for path in code if GLTF_READERS.fullmatch(str(path))}
        self.assertIn(Path("exporters/gltf/read/decode_glb.cpp"), known_by & readers)
        self.assertNone([f"{path}: tinygltf is for readers of .glb files" for path in sorted(known_by - readers)] +
                        [f"{path}: tinygltf writes no glTF here" for path in sorted(readers) if "WriteGltf" in code[path]])

    def test_no_comment_says_todo(self):
        violations = []
        for path in sources():
            for number, line in enumerate((ROOT / path).read_text().splitlines(), 1):
                if re.search(r"\b(TODO|FIXME|XXX|HACK)\b", line):
                    violations.append(f"{path}:{number}: {line.strip()}")
        self.assertNone(violations)


class Stages(unittest.TestCase):
    def assertNone(self, violations):
        if violations:
            self.fail("\n" + "\n".join(violations))

    def test_no_stage_may_change_the_product_of_another(self):
        self.assertNone([f"{path}: {violation}" for path in sources() if path.suffix == ".h" and room_of(path).split("/")[-1] in STAGES + ["compiler"] and path.stem != "parse_values"
                         for violation in changes_of_products((ROOT / path).read_text(), room_of(path).split("/")[-1])])

    def test_the_pipeline_makes_each_product_once(self):
        self.assertNone([f"compiler/pipeline.cpp: {edit}" for edit in edits_in_pipeline((ROOT / "compiler/pipeline.cpp").read_text())])

    def test_changes_are_found(self):
        text = ("void fill(map::Features& features);\nmap::Features with_yards(map::Features features, int a);\n"
                "std::vector<roads::Road> narrowed(std::vector<roads::Road> roads);\nvoid ok(const map::Features& f, std::span<const roads::Road> r);\n"
                "Yards plan(map::Features features);\nvoid own(std::vector<Yard>& yards, Report& report);\n")
        self.assertEqual([violation.split("(")[0] for violation in changes_of_products(text, "lots")], ["fill", "with_yards", "narrowed"])
        part = ("Result<CompileResult> compile_part(int a,\n                 int b) {\n  Report report;\n  const int a = f();\n  features = g(features);\n"
                "  map::Features made = g();\n  recipes.roads = h();\n  return CompileResult{};\n}\n")
        self.assertEqual(len(list(edits_in_pipeline(part))), 3)


if __name__ == "__main__":
    sys.exit(unittest.main(argv=[sys.argv[0], "-v"]))
