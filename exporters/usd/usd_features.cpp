#include "exporters/usd/usd_features.h"

#include <algorithm>

namespace citykiln::exporters {
namespace {

using bake::FeatureAttributes;
using TextColumn = std::vector<std::string>;

void write_ids(UsdBuilder& b) {
  constexpr const char* kTypes[] = {"none", "node", "way", "relation"};
  std::vector<std::int64_t> ids;
  TextColumn types;
  for (const OsmId& id : b.tile.features) {
    ids.push_back(id.id);
    types.emplace_back(kTypes[static_cast<std::size_t>(id.type)]);
  }
  b.writer.write({.type = "int64[]", .name = "osm:id", .value = std::span<const std::int64_t>(ids), .is_custom = true});
  b.writer.write({.type = "token[]", .name = "osm:type", .value = UsdTokens{types}, .is_custom = true});
}

void write_texts(UsdBuilder& b, const char* name, std::string FeatureAttributes::*member) {
  TextColumn texts;
  for (const FeatureAttributes& row : b.tile.attributes) texts.push_back(row.*member);
  if (std::ranges::all_of(texts, &std::string::empty)) return;
  b.writer.write({.type = "string[]", .name = name, .value = std::span<const std::string>(texts), .is_custom = true});
}

void write_heights(UsdBuilder& b) {
  std::vector<float> heights_m;
  for (const FeatureAttributes& row : b.tile.attributes) heights_m.push_back(row.height_m);
  if (std::ranges::all_of(heights_m, [](float h_m) { return h_m == 0; })) return;
  b.writer.write(
      {.type = "float[]", .name = "osm:height_m", .value = std::span<const float>(heights_m), .is_custom = true});
}

}  // namespace

void write_features(UsdBuilder& b) {
  b.writer.begin_prim({.type = "Scope", .name = "features"});
  write_ids(b);
  write_texts(b, "osm:class", &FeatureAttributes::kind);
  write_texts(b, "osm:name", &FeatureAttributes::name);
  write_heights(b);
  write_texts(b, "osm:tags", &FeatureAttributes::tags);
  b.writer.end_prim();
}

}  // namespace citykiln::exporters
