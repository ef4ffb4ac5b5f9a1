#include "exporters/gltf/write/property_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "compiler/contract/erase_repeated.h"
#include "compiler/contract/findings/assumption_names.h"
#include "exporters/gltf/glb_names.h"
#include "exporters/tags_json.h"

namespace citykiln::exporters {
namespace {

using bake::FeatureAttributes;
using Json = nlohmann::json;

// A table while columns are added to it.
struct Columns {
  GlbBuilder& builder;
  Json schema{}, enums{}, values{};

  void add(const char* id, Json property, Json column) {
    schema[id] = std::move(property), values[id] = std::move(column);
  }
};

Json scalar(const char* name, const char* component, const char* description) {
  return {{"name", name}, {"description", description}, {"type", "SCALAR"}, {"componentType", component}};
}

template <typename T>
Json column_of(GlbBuilder& builder, const std::vector<T>& values) {
  return {{"values", builder.add_view(values, ViewUse::kOther)}};
}

void add_ids(Columns& columns) {
  std::vector<std::uint64_t> ids;
  std::vector<std::uint8_t> types;
  for (const OsmId& id : columns.builder.tile.features)
    ids.push_back(static_cast<std::uint64_t>(id.id)), types.push_back(static_cast<std::uint8_t>(id.type));
  columns.add("id", scalar("OSM id", "UINT64", "id of the OpenStreetMap element"), column_of(columns.builder, ids));
  columns.add("type", scalar("OSM type", "UINT8", "0 none, 1 node, 2 way, 3 relation, 4 lot"),
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
  Json names;
  for (std::size_t i = 0; i < kinds.size(); ++i) names.push_back({{"name", i == 0 ? "none" : kinds[i]}, {"value", i}});
  columns.enums["class"] = {{"name", "class"}, {"valueType", "UINT16"}, {"values", std::move(names)}};
  std::vector<std::uint16_t> numbers;
  for (const FeatureAttributes& row : attributes)
    numbers.push_back(static_cast<std::uint16_t>(std::ranges::lower_bound(kinds, row.kind) - kinds.begin()));
  columns.add("class",
              {{"name", "class"},
               {"description", "class of the object"},
               {"type", "ENUM"},
               {"enumType", "class"},
               {"noData", "none"}},
              column_of(columns.builder, numbers));
}

// Where each text begins, and where the last one ends.
template <typename Offset>
Json text_offset_columns(GlbBuilder& builder, const std::vector<std::size_t>& ends, const char* type) {
  std::vector<Offset> offsets = {0};
  for (const std::size_t end : ends) offsets.push_back(static_cast<Offset>(end));
  return {{"stringOffsets", builder.add_view(offsets, ViewUse::kOther)}, {"stringOffsetType", type}};
}

// A column of texts, unless all are empty: a buffer view has at least one byte.
template <typename TextOf>
void add_texts(Columns& columns, const char* id, const char* description, TextOf text_of) {
  std::vector<char> bytes;
  std::vector<std::size_t> ends;
  for (const FeatureAttributes& row : columns.builder.tile.attributes) {
    const std::string& text = std::invoke(text_of, row);
    bytes.insert(bytes.end(), text.begin(), text.end());
    ends.push_back(bytes.size());
  }
  if (bytes.empty()) return;
  GlbBuilder& builder = columns.builder;
  Json column = bytes.size() <= std::numeric_limits<std::uint16_t>::max()
                    ? text_offset_columns<std::uint16_t>(builder, ends, "UINT16")
                    : text_offset_columns<std::uint32_t>(builder, ends, "UINT32");
  column["values"] = builder.add_view(bytes, ViewUse::kOther);
  columns.add(id, {{"name", id}, {"description", description}, {"type", "STRING"}, {"noData", ""}}, std::move(column));
}

void add_heights(Columns& columns) {
  std::vector<float> heights_m;
  for (const FeatureAttributes& row : columns.builder.tile.attributes) heights_m.push_back(row.height_m);
  Json property = scalar("height", "FLOAT32", "height in metres, from foot to top");
  property["noData"] = 0;
  columns.add("height_m", std::move(property), column_of(columns.builder, heights_m));
}

// A column of sets of bits, unless nothing is assumed: files without assumptions have no such column.
void add_assumed(Columns& columns) {
  std::vector<Assumptions> sets;
  for (const FeatureAttributes& row : columns.builder.tile.attributes) sets.push_back(row.assumed);
  if (std::ranges::all_of(sets, [](Assumptions set) { return set == kNoAssumptions; })) return;
  const std::string description = "what is assumed of the object, a sum of bits: " + bits_text();
  Json property = scalar("assumed", "UINT16", description.c_str());
  property["noData"] = 0;
  columns.add("assumed", std::move(property), column_of(columns.builder, sets));
}

// A number that is written without a fraction in 32 bits, else with one.
Json id_value(std::int64_t v) {
  const bool fits = v >= std::numeric_limits<int>::min() && v <= std::numeric_limits<int>::max();
  return fits ? Json(v) : Json(static_cast<double>(v));
}

void add_attributes(const FeatureAttributes& row, Json& extras) {
  if (!row.kind.empty()) extras["class"] = row.kind;
  if (!row.name.empty()) extras["name"] = row.name;
  // as many digits as single precision has, so that 12.3 stays 12.3
  if (row.height_m > 0) extras["height_m"] = std::stod(fmt::format("{}", row.height_m));
  for (const map::TagView& tag : row.tags.views()) extras["tags"][std::string(tag.key)] = tag.value;
  if (row.assumed != kNoAssumptions) extras["assumed"] = names_in(row.assumed);
}

}  // namespace

Json property_table(GlbBuilder& builder) {
  const bake::BakedTile& tile = builder.tile;
  assert(tile.attributes.empty() || tile.attributes.size() == tile.features.size());
  Columns columns{builder};
  add_ids(columns);
  if (!tile.attributes.empty()) {
    add_kinds(columns);
    add_texts(columns, "name", "name of the object", &FeatureAttributes::name);
    add_heights(columns);
    add_texts(columns, "tags", "all tags of the element, as a JSON object",
              [](const FeatureAttributes& row) { return tags_text(row.tags); });
    add_assumed(columns);
  }
  Json schema = {{"id", "citykiln"}, {"classes", {{"osm", {{"properties", std::move(columns.schema)}}}}}};
  if (!columns.enums.empty()) schema["enums"] = std::move(columns.enums);
  Json table = {{"name", "osm"}, {"class", "osm"}, {"count", tile.features.size()}, {"properties", columns.values}};
  builder.extensions.insert(kMetadataExtension);
  return {{"schema", std::move(schema)}, {"propertyTables", Json::array({std::move(table)})}};
}

std::string feature_name(const bake::BakedTile& tile, std::uint32_t feature) {
  assert(feature < tile.features.size());
  const OsmId id = tile.features[feature];
  return id.type == OsmType::kNone ? "none" : fmt::format("{}_{}", name_of(id.type), id.id);
}

Json extras_of(const bake::BakedTile& tile, std::uint32_t feature) {
  assert(feature < tile.features.size());
  const OsmId id = tile.features[feature];
  Json extras = {{"feature", feature}};
  if (id.type != OsmType::kNone) extras["osm_id"] = id_value(id.id), extras["osm_type"] = name_of(id.type);
  if (feature < tile.attributes.size()) add_attributes(tile.attributes[feature], extras);
  return extras;
}

}  // namespace citykiln::exporters
