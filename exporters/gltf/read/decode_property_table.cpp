#include "exporters/gltf/read/decode_property_table.h"

#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "compiler/contract/utf8.h"
#include "exporters/gltf/glb_names.h"

namespace citykiln::exporters {
namespace {

using bake::FeatureAttributes;
using tinygltf::Value;

// Every row has a copy of its class, so that no small file may have a long one.
constexpr std::size_t kMostClassBytes = 64;

// The table and its schema.
struct Table {
  GltfReader& reader;
  const Value& schema;
  const Value& columns;
  std::size_t count;
};

// The first `count` values of a column.
template <typename T>
std::vector<T> values_in(GltfReader& reader, const Value& column, const char* member_name, std::size_t count) {
  const auto bytes = bytes_of(reader, whole(member(column, member_name)));
  expect(count <= bytes.size() / sizeof(T), "the property table to be as long as it says");
  std::vector<T> values(count);
  if (count > 0) std::memcpy(values.data(), bytes.data(), count * sizeof(T));
  return values;
}

std::vector<OsmId> ids_of(const Table& table) {
  const auto ids = values_in<std::uint64_t>(table.reader, member(table.columns, "id"), "values", table.count);
  const auto types = values_in<std::uint8_t>(table.reader, member(table.columns, "type"), "values", table.count);
  std::vector<OsmId> features(table.count);
  for (std::size_t i = 0; i < table.count; ++i) {
    expect(types[i] < kOsmTypeCount, "OSM types from 0 to 4");
    features[i] = {static_cast<OsmType>(types[i]), static_cast<std::int64_t>(ids[i])};
  }
  return features;
}

std::string text_in(const Value& value) {
  expect(value.IsString(), "a text");
  return value.Get<std::string>();
}

// The names of the enum's values, which are numbered from 0; the first one stands for none.
std::vector<std::string> kind_names_in(const Table& table) {
  const Value& values = member(member(member(table.schema, "enums"), "class"), "values");
  expect(values.IsArray() && values.ArrayLen() > 0, "the classes of features");
  std::vector<std::string> kinds = {""};
  for (std::size_t i = 1; i < values.ArrayLen(); ++i) {
    kinds.push_back(text_in(member(values.Get(i), "name")));
    expect(kinds.back().size() <= kMostClassBytes, "short names of classes");
  }
  return kinds;
}

void read_kinds(const Table& table, std::vector<FeatureAttributes>& rows) {
  const std::vector<std::string> kinds = kind_names_in(table);
  const auto numbers = values_in<std::uint16_t>(table.reader, member(table.columns, "class"), "values", table.count);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    expect(numbers[i] < kinds.size(), "classes that the enum lists");
    rows[i].kind = kinds[numbers[i]];
  }
}

void read_heights(const Table& table, std::vector<FeatureAttributes>& rows) {
  const auto heights_m = values_in<float>(table.reader, member(table.columns, "height_m"), "values", table.count);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    expect(std::isfinite(heights_m[i]) && heights_m[i] >= 0, "heights of at least 0");
    rows[i].height_m = heights_m[i];
  }
}

// The column of assumptions, if the table has it.
void read_assumed(const Table& table, std::vector<FeatureAttributes>& rows) {
  if (!table.columns.Has("assumed")) return;
  const auto sets = values_in<Assumptions>(table.reader, member(table.columns, "assumed"), "values", table.count);
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i].assumed = sets[i];
}

std::vector<std::uint32_t> text_offsets_in(const Table& table, const Value& column) {
  if (text_in(member(column, "stringOffsetType")) == "UINT32")
    return values_in<std::uint32_t>(table.reader, column, "stringOffsets", table.count + 1);
  const auto narrow = values_in<std::uint16_t>(table.reader, column, "stringOffsets", table.count + 1);
  return {narrow.begin(), narrow.end()};
}

// A column of texts, if the table has it.
void read_texts(const Table& table, const char* name, std::string FeatureAttributes::*to,
                std::vector<FeatureAttributes>& rows) {
  if (!table.columns.Has(name)) return;
  const Value& column = table.columns.Get(name);
  const std::vector<std::uint32_t> offsets = text_offsets_in(table, column);
  const auto bytes = bytes_of(table.reader, whole(member(column, "values")));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    expect(offsets[i] <= offsets[i + 1] && offsets[i + 1] <= bytes.size(), "texts inside their buffer view");
    (rows[i].*to).assign(reinterpret_cast<const char*>(bytes.data()) + offsets[i], offsets[i + 1] - offsets[i]);
    expect(is_utf8(rows[i].*to), "texts in UTF-8");
  }
}

}  // namespace

void read_property_table(GltfReader& reader, bake::BakedTile& tile) {
  const auto extension = reader.model.extensions.find(kMetadataExtension);
  expect(extension != reader.model.extensions.end(), "the table of OSM ids");
  const Value& tables = member(extension->second, "propertyTables");
  expect(tables.IsArray() && tables.ArrayLen() > 0, "the table of OSM ids");
  const auto count = whole(member(tables.Get(0), "count"));
  const Table table{reader, member(extension->second, "schema"), member(tables.Get(0), "properties"),
                    static_cast<std::size_t>(std::max(0, count))};
  tile.features = ids_of(table);
  if (!table.columns.Has("class")) return;
  tile.attributes.resize(table.count);
  read_kinds(table, tile.attributes);
  read_texts(table, "name", &FeatureAttributes::name, tile.attributes);
  read_heights(table, tile.attributes);
  read_texts(table, "tags", &FeatureAttributes::tags, tile.attributes);
  read_assumed(table, tile.attributes);
}

}  // namespace citykiln::exporters
