"""Reads USD independently of the product: layers as text (.usda) and as crates (.usdc), and composes payloads and variants.

Written from the specifications of OpenUSD ("USD ASCII format", "USDC File Format Specification", "Glossary": strength ordering).
"""
import re
import struct
from pathlib import Path

TOKEN = re.compile(r'\s+|#[^\n]*|("(?:[^"\\]|\\.)*")|@([^@]*)@|<([^>]*)>|([-+]?(?:\d+\.?\d*(?:[eE][-+]?\d+)?|inf|nan)\b)|'
                   r'([A-Za-z_][\w:.]*)|([()\[\]{}=,;])', re.S)
SPECIFIERS = ("def", "over", "class")


class UsdError(Exception):
    """A file that is not a layer, or a reference to what is not there."""


class Spec:
    """The opinions of one layer about one prim: `metadata`, `attributes` (name to value), `details` (name to its metadata),
    `targets` (name to paths, of relationships and connections), `children` and `variants` (set to name to Spec)."""

    def __init__(self, kind=""):
        self.kind, self.metadata, self.attributes, self.details = kind, {}, {}, {}
        self.targets, self.children, self.variants = {}, {}, {}


class Text:
    """A parser of .usda."""

    def __init__(self, text):
        if not text.startswith("#usda 1.0"):
            raise UsdError("no #usda 1.0")
        self.tokens, at = [], 0
        while at < len(text):
            found = TOKEN.match(text, at)
            if not found:
                raise UsdError(f"unexpected text {text[at:at + 20]!r}")
            at = found.end()
            for kind, name in enumerate(("string", "asset", "path", "number", "word", "mark"), 1):
                if found.group(kind) is not None:
                    self.tokens.append((name, found.group(kind)))
        self.at = 0

    def peek(self):
        return self.tokens[self.at] if self.at < len(self.tokens) else ("end", "")

    def take(self, kind=None, text=None):
        token = self.peek()
        if (kind and token[0] != kind) or (text and token[1] != text):
            raise UsdError(f"expected {text or kind}, found {token}")
        self.at += 1
        return token[1]

    def skip(self, mark):
        found = self.peek() == ("mark", mark)
        self.at += found
        return found

    def string(self):
        body = self.take("string")[1:-1]
        return re.sub(r"\\(x[0-9a-fA-F]{2}|.)", lambda m: {"n": "\n"}.get(m[1], chr(int(m[1][1:], 16)) if len(m[1]) > 1 else m[1]), body)

    def value(self):
        kind, text = self.peek()
        if kind == "string":
            return self.string()
        if kind in ("asset", "path"):
            return self.take()
        if kind == "number":
            return float(self.take())
        if kind == "word":
            if text not in ("true", "false", "None"):
                raise UsdError(f"no value: {text}")
            return {"true": True, "false": False, "None": None}[self.take()]
        if text == "{":
            return self.dictionary()
        closing = {"(": ")", "[": "]"}.get(self.take("mark"))
        values = []
        while not self.skip(closing):
            values.append(self.value())
            self.skip(",")
        return values

    def type(self):
        self.take("word")
        if self.skip("["):
            self.take("mark", "]")

    def dictionary(self):
        entries = {}
        self.take("mark", "{")
        while not self.skip("}"):
            self.type()
            name = self.take()
            self.take("mark", "=")
            entries[name] = self.value()
        return entries

    def metadata(self):
        entries = {}
        if self.skip("("):
            while not self.skip(")"):
                name = self.take("word")
                if name in ("prepend", "append", "add"):
                    name = self.take("word")
                self.take("mark", "=")
                entries[name] = self.value()
        return entries

    def layer(self):
        root = Spec("layer")
        root.metadata = self.metadata()
        while self.peek()[0] != "end":
            self.prim(root)
        return root

    def prim(self, parent):
        if self.take("word") not in SPECIFIERS:
            raise UsdError("expected a prim")
        spec = Spec(self.take("word") if self.peek()[0] == "word" else "")
        name = self.string()
        if name in parent.children:
            raise UsdError(f"{name} twice")
        parent.children[name] = spec
        spec.metadata = self.metadata()
        self.body(spec)

    def body(self, spec):
        self.take("mark", "{")
        while not self.skip("}"):
            if self.peek()[1] in SPECIFIERS:
                self.prim(spec)
            elif self.peek()[1] == "variantSet":
                self.variant_set(spec)
            else:
                self.property(spec)

    def variant_set(self, spec):
        self.take()
        name = self.string()
        self.take("mark", "="), self.take("mark", "{")
        variants = spec.variants.setdefault(name, {})
        while not self.skip("}"):
            variant = variants[self.string()] = Spec()
            variant.metadata = self.metadata()
            self.body(variant)

    def property(self, spec):
        while self.peek()[1] in ("custom", "uniform", "prepend"):
            self.take()
        is_relationship = self.peek()[1] == "rel"
        self.type()
        name = self.take("word")
        is_connection = name.endswith(".connect")
        if self.skip("="):
            value = self.value()
            if is_relationship or is_connection:
                spec.targets[name.removesuffix(".connect")] = value if isinstance(value, list) else [value]
            else:
                spec.attributes[name] = value
        spec.details[name.removesuffix(".connect")] = self.metadata()


# ---- crates ----

# Number of a type: its name, format of one number, numbers in a value.
TYPES = {1: ("bool", "B", 1), 3: ("int", "i", 1), 5: ("int64", "q", 1), 8: ("float", "f", 1), 9: ("double", "d", 1),
         10: ("string", "I", 1), 11: ("token", "I", 1), 12: ("asset", "I", 1), 18: ("quath", "e", 4), 20: ("float2", "f", 2),
         23: ("double3", "d", 3), 24: ("float3", "f", 3), 28: ("float4", "f", 4)}


def unpack_lz4(packed, size):
    """One block, as LZ4's block format describes it."""
    out, at = bytearray(), 0
    while at < len(packed):
        sizes = packed[at]
        at += 1
        literals = sizes >> 4
        if literals == 15:
            while True:
                literals, at = literals + packed[at], at + 1
                if packed[at - 1] != 255:
                    break
        out += packed[at:at + literals]
        at += literals
        if at >= len(packed):
            break
        back = packed[at] | packed[at + 1] << 8
        at += 2
        length = (sizes & 15) + 4
        if length == 19:
            while True:
                length, at = length + packed[at], at + 1
                if packed[at - 1] != 255:
                    break
        start = len(out) - back
        if back == 0 or start < 0:
            raise UsdError("damaged LZ4")
        while length > 0:
            part = out[start:start + min(back, length)]
            out += part
            length -= len(part)
            start += len(part)
    if len(out) > size:
        raise UsdError("damaged LZ4")
    return bytes(out)


class Crate:
    """A parser of .usdc. `places` has the offset of the first value of each plain array, by path of the attribute."""

    def __init__(self, data):
        if data[:8] != b"PXR-USDC" or data[8] != 0 or data[9] < 7:
            raise UsdError("no crate of version 0.7 or later")
        self.data, self.places = data, {}
        contents = struct.unpack_from("<q", data, 16)[0]
        self.sections = {}
        for i in range(struct.unpack_from("<Q", data, contents)[0]):
            name, start, _ = struct.unpack_from("<16sqq", data, contents + 8 + 32 * i)
            self.sections[name.rstrip(b"\0").decode()] = start
        self.read_tokens()
        self.read_fields()

    def count(self, at):
        return struct.unpack_from("<Q", self.data, at)[0], at + 8

    def packed(self, at, size):
        packed_size, at = self.count(at)
        packed = self.data[at:at + packed_size]
        if packed[0] != 0:
            raise UsdError("several blocks")
        return unpack_lz4(packed[1:], size), at + packed_size

    def integers(self, at, count):
        first = 4 + (2 * count + 7) // 8
        coded, end = self.packed(at, first + 4 * count)
        common, number, numbers = struct.unpack_from("<i", coded)[0], 0, []
        forms = (None, ("<b", 1), ("<h", 2), ("<i", 4))
        at = first
        for i in range(count):
            form = forms[coded[4 + i // 4] >> 2 * (i % 4) & 3]
            step = common
            if form:
                step, at = struct.unpack_from(form[0], coded, at)[0], at + form[1]
            number = (number + step + 2**31) % 2**32 - 2**31
            numbers.append(number)
        return numbers, end

    def read_tokens(self):
        at = self.sections["TOKENS"]
        count, at = self.count(at)
        size, at = self.count(at)
        self.tokens = [t.decode() for t in self.packed(at, size)[0].split(b"\0")[:-1]]
        if len(self.tokens) != count:
            raise UsdError("another number of tokens")
        count, at = self.count(self.sections["STRINGS"])
        self.strings = struct.unpack_from(f"<{count}I", self.data, at)

    def read_fields(self):
        count, at = self.count(self.sections["FIELDS"])
        names, at = self.integers(at, count)
        values = struct.unpack(f"<{count}Q", self.packed(at, 8 * count)[0])
        self.fields = [(self.tokens[name], value) for name, value in zip(names, values)]
        count, at = self.count(self.sections["FIELDSETS"])
        self.field_sets = self.integers(at, count)[0]

    def read_paths(self):
        """The path of each number, in the order of the file."""
        count, at = self.count(self.sections["PATHS"])
        numbers, at = self.integers(at + 8, count)
        names, at = self.integers(at, count)
        jumps, at = self.integers(at, count)
        paths = {}

        def read(at, parent):
            while True:
                name = self.tokens[abs(names[at])]
                path = "/" if at == 0 else f"{parent}.{name}" if names[at] < 0 else f"{parent.rstrip('/')}/{name}"
                paths[numbers[at]] = path
                if jumps[at] > 0 or jumps[at] == -1:
                    read(at + 1, path)
                if jumps[at] < 0:
                    return
                at += jumps[at] or 1

        read(0, "")
        return paths

    def specs(self):
        count, at = self.count(self.sections["SPECS"])
        paths, at = self.integers(at, count)
        sets, at = self.integers(at, count)
        types, at = self.integers(at, count)
        for path, first, kind in zip(paths, sets, types):
            end = self.field_sets.index(-1, first)
            yield path, dict(self.fields[i] for i in self.field_sets[first:end]), kind

    def texts(self, kind, numbers):
        return [self.tokens[self.strings[n] if kind == "string" else n] for n in numbers]

    def array(self, kind, form, width, rep, place):
        at = rep & 2**48 - 1
        if at == 0:
            return []
        count, at = self.count(at)
        if rep >> 61 & 1:
            return self.integers(at, count)[0]
        self.places[place] = at
        numbers = struct.unpack_from(f"<{count * width}{form}", self.data, at)
        if kind in ("string", "token", "asset"):
            return self.texts(kind, numbers)
        if kind == "quath":  # the real part is stored last, and written first in text
            numbers = [n for q in zip(*[iter(numbers)] * 4) for n in (q[3], *q[:3])]
        return list(numbers) if width == 1 else list(map(list, zip(*[iter(numbers)] * width)))

    def dictionary(self, rep):
        at = rep & 2**48 - 1
        count, at = self.count(at)
        entries = {}
        for _ in range(count):
            name, offset = struct.unpack_from("<Iq", self.data, at)
            entries[self.tokens[self.strings[name]]] = self.value(struct.unpack_from("<Q", self.data, at + 4 + offset)[0])
            at += 20
        return entries

    def paths_of(self, rep):
        at = rep & 2**48 - 1
        if self.data[at] != 3:
            raise UsdError("a list that is not explicit")
        count, at = self.count(at + 1)
        return [self.paths[n] for n in struct.unpack_from(f"<{count}I", self.data, at)]

    def value(self, rep, place=""):
        number = rep >> 48 & 255
        if number == 31:
            return self.dictionary(rep)
        if number in (32, 41, 42, 44):  # lists of tokens, specifier, variability: not needed here
            return None
        if number == 34:
            return self.paths_of(rep)
        kind, form, width = TYPES[number]
        if rep >> 63:
            return self.array(kind, form, width, rep, place)
        if rep >> 62 & 1:
            raw = struct.pack("<Q", rep & 2**48 - 1)
            found = struct.unpack_from("<" + form, raw)[0]
            return self.texts(kind, [found])[0] if kind in ("string", "token", "asset") else found
        numbers = list(struct.unpack_from(f"<{width}{form}", self.data, rep & 2**48 - 1))
        return numbers[0] if width == 1 else numbers

    def layer(self):
        self.paths = self.read_paths()
        specs = {self.paths[path]: (fields, kind) for path, fields, kind in self.specs()}
        root, prims = Spec("layer"), {}
        for path in self.paths.values():
            fields, kind = specs[path]
            if kind in (6, 7):
                spec = prims[path] = root if kind == 7 else Spec(self.value(fields["typeName"]))
                spec.metadata = {name: self.value(rep) for name, rep in fields.items()}
                if kind == 6:
                    parent, name = path.rsplit("/", 1)
                    prims[parent or "/"].children[name] = spec
                continue
            owner, name = path.split(".", 1)
            spec = prims[owner]
            if "default" in fields:
                spec.attributes[name] = self.value(fields["default"], path)
            for field in ("targetPaths", "connectionPaths"):
                if field in fields:
                    spec.targets[name] = self.paths_of(fields[field])
            spec.details[name] = {k: self.value(v) for k, v in fields.items() if k in ("interpolation", "typeName")}
        return root


def read_layer(path):
    """The root Spec of a layer."""
    try:
        data = Path(path).read_bytes()
    except OSError as problem:
        raise UsdError(f"{path} cannot be read") from problem
    if data.startswith(b"PXR-USDC"):
        return Crate(data).layer()
    return Text(data.decode()).layer()


# ---- composition ----


class Prim:
    """A composed prim: the strongest opinion of each kind wins. `path` is that in the stage, `layers` the files it is from."""

    def __init__(self, path):
        self.path, self.kind, self.metadata, self.attributes = path, "", {}, {}
        self.details, self.targets, self.children, self.layers = {}, {}, {}, []

    def add(self, spec, file, renamed):
        self.kind = self.kind or spec.kind
        self.metadata = spec.metadata | self.metadata
        self.attributes = spec.attributes | self.attributes
        self.details = spec.details | self.details
        self.targets = {n: [renamed(p) for p in paths] for n, paths in spec.targets.items()} | self.targets
        self.layers.append(file)

    def below(self, kind):
        """This prim and all below it of a kind, depth first."""
        return ([self] if self.kind == kind else []) + [p for c in self.children.values() for p in c.below(kind)]

    def at(self, path):
        """The prim at a path relative to this one; an error where there is none."""
        prim = self
        for name in filter(None, path.split("/")):
            if name not in prim.children:
                raise UsdError(f"{self.path} has no {path}")
            prim = prim.children[name]
        return prim


class Stage:
    """A layer with all that it refers to. `levels` chooses variants by path of a prim, before the file's own choice."""

    def __init__(self, path, levels=None, loads=True):
        self.levels, self.loads, self.files = levels or {}, loads, {}
        self.root = Prim("")
        root = self.layer(Path(path))
        self.metadata = root.metadata
        for name, spec in root.children.items():
            self.root.children[name] = self.composed([(spec, Path(path), "/" + name, "/" + name)], "/" + name)
        if root.metadata.get("defaultPrim") not in root.children:
            raise UsdError(f"{path}: no default prim")
        self.default = self.root.children[root.metadata["defaultPrim"]]

    def layer(self, path):
        path = path.resolve()
        if path not in self.files:
            self.files[path] = read_layer(path)
        return self.files[path]

    def arcs(self, spec, file, path, prim):
        """The variants, then the payloads of a spec: strongest first (local, inherits, variants, references, payloads)."""
        found = []
        for name, variants in spec.variants.items():
            choice = self.levels.get(path) or prim.metadata.get("variants", {}).get(name)
            if choice is None:
                continue
            if choice not in variants:
                raise UsdError(f"{path} has no variant {name}={choice}")
            found.append((variants[choice], file))
        payloads = spec.metadata.get("payload", []) if self.loads else []
        for asset in [payloads] if isinstance(payloads, str) else payloads:
            target = file.parent / asset
            layer = self.layer(target)
            name = layer.metadata.get("defaultPrim")
            if name not in layer.children:
                raise UsdError(f"{target}: no default prim")
            found.append((layer.children[name], target))
        return found

    def composed(self, sources, path):
        """@param sources: (spec, file, path of the arc's root in the file, the same in the stage), strongest first."""
        prim = Prim(path)
        queue, specs = list(sources), []
        while queue:
            spec, file, own, mapped = queue.pop(0)
            prim.add(spec, file, lambda p, own=own, mapped=mapped: mapped + p[len(own):] if p.startswith(own) else p)
            specs.append((spec, file, own, mapped))
            for other, target in self.arcs(spec, file, path, prim):
                root = (own, mapped) if target == file else ("/" + self.layer(target).metadata["defaultPrim"], path)
                queue.append((other, target, *root))
        names = list(dict.fromkeys(name for spec, *_ in specs for name in spec.children))
        for name in names:
            own = [(spec.children[name], file, a, b) for spec, file, a, b in specs if name in spec.children]
            prim.children[name] = self.composed(own, f"{path}/{name}")
        return prim


# ---- what a stage says, and what is wrong with it ----


def rotated(q, v):
    """A vector turned by a quaternion (real part first)."""
    w, x, y, z = q
    t = [2 * (y * v[2] - z * v[1]), 2 * (z * v[0] - x * v[2]), 2 * (x * v[1] - y * v[0])]
    return [v[0] + w * t[0] + y * t[2] - z * t[1], v[1] + w * t[1] + z * t[0] - x * t[2], v[2] + w * t[2] + x * t[1] - y * t[0]]


def faults(stage):
    """The faults of the prims of a stage, a line each."""
    found = []
    for mesh in stage.root.below("Mesh"):
        points, indices = mesh.attributes["points"], mesh.attributes["faceVertexIndices"]
        if sum(mesh.attributes["faceVertexCounts"]) != len(indices):
            found.append(f"{mesh.path}: counts of faces")
        if not all(0 <= i < len(points) for i in indices):
            found.append(f"{mesh.path}: an index beyond its points")
        low, high = [list(map(f, zip(*points))) for f in (min, max)]
        if mesh.attributes["extent"] != [low, high]:
            found.append(f"{mesh.path}: extent")
        for target in mesh.targets.get("material:binding", [""]):
            try:
                if stage.root.at(target).kind != "Material":
                    found.append(f"{mesh.path}: bound to no material")
            except UsdError as problem:
                found.append(f"{mesh.path}: {problem}")
    for instancer in stage.root.below("PointInstancer"):
        prototypes, count = instancer.targets.get("prototypes", []), len(instancer.attributes["positions"])
        if not all(0 <= i < len(prototypes) for i in instancer.attributes["protoIndices"]):
            found.append(f"{instancer.path}: an index beyond its prototypes")
        for name in ("protoIndices", "orientations", "scales", "ids", "primvars:feature"):
            if len(instancer.attributes[name]) != count:
                found.append(f"{instancer.path}: {name}")
        for target in prototypes:
            try:
                stage.root.at(target)
            except UsdError as problem:
                found.append(f"{instancer.path}: {problem}")
    for shader in stage.root.below("Shader"):
        if "inputs:file" in shader.attributes and not (shader.layers[0].parent / shader.attributes["inputs:file"]).exists():
            found.append(f"{shader.path}: a texture that is not there")
        for name, targets in shader.targets.items():
            for target in targets:
                try:
                    stage.root.at(target.split(".")[0])
                except UsdError as problem:
                    found.append(f"{shader.path}.{name}: {problem}")
    return found
