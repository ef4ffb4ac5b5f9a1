"""The property table of a tile: facts about the objects of the map, by row. Does not need Blender."""
import numpy

COLUMN_DTYPES = {"UINT8": numpy.uint8, "UINT16": numpy.uint16, "UINT32": numpy.uint32, "UINT64": numpy.uint64,
                 "INT32": numpy.int32, "FLOAT32": numpy.float32}
TYPES = ["none", "node", "way", "relation", "lot"]


def read_table(glb):
    """The columns as lists, by name: id, type, class, name, height_m, tags, assumed. Row 0 means no object. {} without a table."""
    metadata = glb.gltf.get("extensions", {}).get("EXT_structural_metadata")
    if metadata is None:
        return {}
    [table] = metadata["propertyTables"]
    schema = metadata["schema"]
    columns = {}
    for name, property_ in schema["classes"][table["class"]]["properties"].items():
        if name in table["properties"]:
            columns[name] = read_column(glb, schema, property_, table["properties"][name], table["count"])
    if "assumed" in columns:
        names = bit_names(schema["classes"][table["class"]]["properties"]["assumed"]["description"])
        columns["assumed"] = [", ".join(name for bit, name in names if bits & bit) for bits in columns["assumed"]]
    if "type" in columns:
        columns["type"] = [TYPES[number] for number in columns["type"]]
    return columns


def bit_names(description):
    """Bits and their names, from a text that ends so: "a sum of bits: 1 pavements, 2 lamps"."""
    words = [part.split() for part in description.rpartition(":")[2].split(",")]
    return [(int(bit), name) for bit, name in words]


def read_column(glb, schema, property_, column, count):
    if property_["type"] == "STRING":
        return read_texts(glb, column, count)
    if property_["type"] == "ENUM":
        enum = schema["enums"][property_["enumType"]]
        names = {item["value"]: item["name"] for item in enum["values"]}
        names[0] = ""  # the file calls it none
        numbers = numpy.frombuffer(glb.view(column["values"]), COLUMN_DTYPES[enum["valueType"]], count)
        return [names[number] for number in numbers.tolist()]
    values = numpy.frombuffer(glb.view(column["values"]), COLUMN_DTYPES[property_["componentType"]], count)
    # as many digits as single precision has, so that 12.3 stays 12.3
    return [float(str(v)) for v in values] if values.dtype == numpy.float32 else values.tolist()


def read_texts(glb, column, count):
    offsets = numpy.frombuffer(glb.view(column["stringOffsets"]), COLUMN_DTYPES[column.get("stringOffsetType", "UINT32")],
                               count + 1).tolist()
    data = bytes(glb.view(column["values"]))
    return [data[begin:end].decode("utf-8", "replace") for begin, end in zip(offsets, offsets[1:])]


def facts_of_row(columns, row):
    """The known facts of an object, with the names of glTF's extras: osm_id, osm_type, class, name, height_m, tags, assumed."""
    facts = {name: columns[name][row] for name in ("class", "name", "height_m", "tags", "assumed")
             if name in columns and columns[name][row]}
    if columns["type"][row] != "none":
        facts = {"osm_id": columns["id"][row], "osm_type": columns["type"][row]} | facts
    return facts
