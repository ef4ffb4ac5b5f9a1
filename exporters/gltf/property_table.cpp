#include "exporters/gltf/property_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "compiler/contract/erase_repeated.h"

namespace citykiln::exporters {
namespace {

using bake::FeatureAttributes;
using tinygltf::Value;
using Object = Value::Object;
using Array = Value::Array;

Value text_value(std::string_view s) { return Value(std::string(s)); }
Value whole_value(std::size_t v) { return Value(static_cast<int>(v)); }

// A table while columns are added to it.
struct Columns {
  GlbBuilder& builder;
  Object schema{}, enums{}, values{};

  void add(const char* id, Object property, Object column) {
    schema[id] = Value(std::move(property)), values[id] = Value(std::move(column));
  }
};

Object scalar(const char* name, const char* component, const char* description) {
  return {{"name", text_value(name)},
          {"description", text_value(description)},
          {"type", text_value("SCALAR")},
          {"componentType", text_value(component)}};
}

template <typename T>
Object column_of(GlbBuilder& builder, const std::vector<T>& values) {
  return {{"values", Value(builder.add_view(values, 0))}};
}

void add_ids(Columns& columns) {
  std::vector<std::uint64_t> ids;
  std::vector<std::uint8_t> types;
  for (const OsmId& id : columns.builder.tile.features)
    ids.push_back(static_cast<std::uint64_t>(id.id)), types.push_back(static_cast<std::uint8_t>(id.type));
  columns.add("id", scalar("OSM id", "UINT64", "id of the OpenStreetMap element"), column_of(columns.builder, ids));
  columns.add("type", scalar("OSM type", "UINT8", "0 none, 1 node, 2 way, 3 relation"),
              column_of(columns.builder, types));
}

// The classes of the tile's features, sorted; the first one is empty.
std::vector<std::string> sorted_kinds(const std::vector<FeatureAttributes>& attributes) {
  std::vector<std::string> kinds = {""};
  for (const FeatureAttributes& row : attributes) kinds.push_back(row.kind);
  sort_unique(kinds);
  return kinds;
}

void add_kinds(Columns& columns) {
  const std::vector<FeatureAttributes>& attributes = columns.builder.tile.attributes;
  const std::vector<std::string> kinds = sorted_kinds(attributes);
  assert(kinds.size() <= std::numeric_limits<std::uint16_t>::max());
  Array names;
  for (std::size_t i = 0; i < kinds.size(); ++i)
    names.push_back(Value(Object{{"name", text_value(i == 0 ? "none" : kinds[i])}, {"value", whole_value(i)}}));
  columns.enums["class"] = Value(
      Object{{"name", text_value("class")}, {"valueType", text_value("UINT16")}, {"values", Value(std::move(names))}});
  std::vector<std::uint16_t> numbers;
  for (const FeatureAttributes& row : attributes)
    numbers.push_back(static_cast<std::uint16_t>(std::ranges::lower_bound(kinds, row.kind) - kinds.begin()));
  columns.add("class",
              {{"name", text_value("class")},
               {"description", text_value("class of the object")},
               {"type", text_value("ENUM")},
               {"enumType", text_value("class")},
               {"noData", text_value("none")}},
              column_of(columns.builder, numbers));
}

// Where each text begins, and where the last one ends.
template <typename Offset>
Object text_offset_columns(GlbBuilder& builder, const std::vector<std::size_t>& ends, const char* type) {
  std::vector<Offset> offsets = {0};
  for (const std::size_t end : ends) offsets.push_back(static_cast<Offset>(end));
  return {{"stringOffsets", Value(builder.add_view(offsets, 0))}, {"stringOffsetType", text_value(type)}};
}

// A column of texts, unless all are empty: a buffer view has at least one byte.
void add_texts(Columns& columns, const char* id, const char* description, std::string FeatureAttributes::*member) {
  std::vector<char> bytes;
  std::vector<std::size_t> ends;
  for (const FeatureAttributes& row : columns.builder.tile.attributes) {
    bytes.insert(bytes.end(), (row.*member).begin(), (row.*member).end());
    ends.push_back(bytes.size());
  }
  if (bytes.empty()) return;
  GlbBuilder& builder = columns.builder;
  Object column = bytes.size() <= std::numeric_limits<std::uint16_t>::max()
                      ? text_offset_columns<std::uint16_t>(builder, ends, "UINT16")
                      : text_offset_columns<std::uint32_t>(builder, ends, "UINT32");
  column["values"] = Value(builder.add_view(bytes, 0));
  columns.add(id,
              {{"name", text_value(id)},
               {"description", text_value(description)},
               {"type", text_value("STRING")},
               {"noData", text_value("")}},
              std::move(column));
}

void add_heights(Columns& columns) {
  std::vector<float> heights_m;
  for (const FeatureAttributes& row : columns.builder.tile.attributes) heights_m.push_back(row.height_m);
  Object property = scalar("height", "FLOAT32", "height in metres, from foot to top");
  property["noData"] = Value(0);
  columns.add("height_m", std::move(property), column_of(columns.builder, heights_m));
}

// A number that JSON shows without a fraction; tinygltf's whole numbers have 32 bits.
Value id_value(std::int64_t v) {
  const bool fits = v >= std::numeric_limits<int>::min() && v <= std::numeric_limits<int>::max();
  return fits ? Value(static_cast<int>(v)) : Value(static_cast<double>(v));
}

std::string osm_type_name(OsmType type) {
  constexpr const char* kNames[] = {"none", "node", "way", "relation"};
  return kNames[static_cast<std::size_t>(type)];
}

// The tags as an object of texts; empty where they are no JSON object.
Value tags_object(const std::string& json) {
  Object tags;
  const nlohmann::json parsed = nlohmann::json::parse(json, nullptr, false);
  if (parsed.is_object())
    for (const auto& [key, value] : parsed.items())
      if (value.is_string()) tags[key] = text_value(value.get_ref<const std::string&>());
  return Value(std::move(tags));
}

void add_attributes(const FeatureAttributes& row, Object& extras) {
  if (!row.kind.empty()) extras["class"] = text_value(row.kind);
  if (!row.name.empty()) extras["name"] = text_value(row.name);
  // as many digits as single precision has, so that 12.3 stays 12.3
  if (row.height_m > 0) extras["height_m"] = Value(std::stod(fmt::format("{}", row.height_m)));
  if (!row.tags.empty()) extras["tags"] = tags_object(row.tags);
}

}  // namespace

Value property_table(GlbBuilder& builder) {
  const bake::BakedTile& tile = builder.tile;
  assert(tile.attributes.empty() || tile.attributes.size() == tile.features.size());
  Columns columns{builder};
  add_ids(columns);
  if (!tile.attributes.empty()) {
    add_kinds(columns);
    add_texts(columns, "name", "name of the object", &FeatureAttributes::name);
    add_heights(columns);
    add_texts(columns, "tags", "all tags of the element, as a JSON object", &FeatureAttributes::tags);
  }
  Object schema = {{"id", text_value("citykiln")},
                   {"classes", Value(Object{{"osm", Value(Object{{"properties", Value(columns.schema)}})}})}};
  if (!columns.enums.empty()) schema["enums"] = Value(columns.enums);
  const Object table = {{"name", text_value("osm")},
                        {"class", text_value("osm")},
                        {"count", whole_value(tile.features.size())},
                        {"properties", Value(columns.values)}};
  builder.extensions.insert("EXT_structural_metadata");
  return Value(Object{{"schema", Value(schema)}, {"propertyTables", Value(Array{Value(table)})}});
}

std::string feature_name(const bake::BakedTile& tile, std::uint32_t feature) {
  assert(feature < tile.features.size());
  const OsmId id = tile.features[feature];
  return id.type == OsmType::kNone ? "none" : fmt::format("{}_{}", osm_type_name(id.type), id.id);
}

Value extras_of(const bake::BakedTile& tile, std::uint32_t feature) {
  assert(feature < tile.features.size());
  const OsmId id = tile.features[feature];
  Object extras = {{"feature", whole_value(feature)}};
  if (id.type != OsmType::kNone)
    extras["osm_id"] = id_value(id.id), extras["osm_type"] = text_value(osm_type_name(id.type));
  if (feature < tile.attributes.size()) add_attributes(tile.attributes[feature], extras);
  return Value(std::move(extras));
}

}  // namespace citykiln::exporters
