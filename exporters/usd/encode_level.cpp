#include "exporters/usd/encode_level.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <memory>

#include "compiler/contract/findings/assumption_names.h"
#include "exporters/joined_attributions.h"
#include "exporters/tags_json.h"
#include "exporters/usd/crate_writer.h"
#include "exporters/usd/text_writer.h"
#include "exporters/usd/usd_builder.h"
#include "exporters/usd/usd_materials.h"
#include "exporters/usd/usd_meshes.h"

namespace citykiln::exporters {
namespace {

// ---- features -------------------------------------------------------------------------------------------------------

using bake::FeatureAttributes;
using TextColumn = std::vector<std::string>;

void write_ids(UsdBuilder& b) {
  std::vector<std::int64_t> ids;
  TextColumn types;
  for (const OsmId& id : b.tile.features) {
    ids.push_back(id.id);
    types.emplace_back(name_of(id.type));
  }
  b.writer.write({.type = "int64[]", .name = "osm:id", .value = std::span<const std::int64_t>(ids), .is_custom = true});
  b.writer.write({.type = "token[]", .name = "osm:type", .value = UsdTokens{types}, .is_custom = true});
}

template <typename TextOf>
void write_texts(UsdBuilder& b, const char* name, TextOf text_of) {
  TextColumn texts;
  for (const FeatureAttributes& row : b.tile.attributes) texts.push_back(std::invoke(text_of, row));
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

void write_assumed(UsdBuilder& b) {
  TextColumn texts;
  for (const FeatureAttributes& row : b.tile.attributes)
    texts.push_back(fmt::format("{}", fmt::join(names_in(row.assumed), " ")));
  if (std::ranges::all_of(texts, &std::string::empty)) return;
  b.writer.write(
      {.type = "string[]", .name = "osm:assumed", .value = std::span<const std::string>(texts), .is_custom = true});
}

// Writes the scope "features". Element i of each array belongs to feature i, to which primvars:feature refers; element
// 0 means "no feature".
//
// | attribute     | type     | value                                              |
// |---------------|----------|----------------------------------------------------|
// | osm:id        | int64[]  | id of the OpenStreetMap element                    |
// | osm:type      | token[]  | "none", "node", "way", "relation" or "lot"         |
// | osm:class     | string[] | its class, "Apartments"                            |
// | osm:name      | string[] | name=*, or ""                                      |
// | osm:height_m  | float[]  | from foot to top, or 0                             |
// | osm:tags      | string[] | all tags as a JSON object, where the scene keeps them |
// | osm:assumed   | string[] | names of what is assumed of it, or ""              |
//
// Leaves out columns without values.
void write_feature_table(UsdBuilder& b) {
  b.writer.begin_prim({.type = "Scope", .name = "features"});
  write_ids(b);
  write_texts(b, "osm:class", &FeatureAttributes::kind);
  write_texts(b, "osm:name", &FeatureAttributes::name);
  write_heights(b);
  write_texts(b, "osm:tags", [](const FeatureAttributes& row) { return tags_text(row.tags); });
  write_assumed(b);
  b.writer.end_prim();
}

using bake::Layer;

UsdDictionary tile_data(const bake::BakedTile& tile, const scene::Header& header) {
  return {{"tile", to_string(tile.tile)},        {"origin_m", tile.origin},
          {"tolerance_m", tile.tolerance_m},     {"error_m", tile.error_m},
          {"plant_error_m", tile.plant_error_m}, {"lon_0", header.origin.lon_deg},
          {"lat_0", header.origin.lat_deg}};
}

// The part of a list sorted by layer that belongs to one layer.
template <typename T, typename LayerOf>
std::span<const T> part_of(const std::vector<T>& sorted, Layer layer, LayerOf layer_of) {
  const auto first = std::ranges::lower_bound(sorted, layer, {}, layer_of);
  const auto last = std::ranges::upper_bound(first, sorted.end(), layer, {}, layer_of);
  return {first, last};
}

void write_layer(UsdBuilder& b, Layer layer) {
  const auto primitives = part_of(b.tile.primitives, layer, &bake::Primitive::layer);
  const auto instanced =
      part_of(b.tile.instanced, layer, [](const bake::InstancedMesh& mesh) { return layer_of(mesh); });
  if (primitives.empty() && instanced.empty()) return;
  const std::string name(name_of(layer));
  b.writer.begin_prim({.type = "Xform", .name = name});
  include(b.bounds, write_meshes(b, primitives, nullptr));
  if (!instanced.empty()) write_instances(b, fmt::format("{}/{}", kUsdTilePath, name), instanced);
  b.writer.end_prim();
}

std::unique_ptr<LayerWriter> writer_of(UsdForm form, const UsdLayerHead& head) {
  if (form == UsdForm::kText) return std::make_unique<TextWriter>(head);
  return std::make_unique<CrateWriter>(head);
}

}  // namespace

UsdLevel encode_level(const bake::BakedTile& tile, const scene::Header& header, const std::string& texture_folder,
                      UsdForm form) {
  const auto writer = writer_of(
      form, {.default_prim = "tile", .custom_data = {{"attribution", joined_attributions(header.attributions)}}});
  UsdBuilder b{.tile = tile, .writer = *writer, .texture_folder = texture_folder};
  writer->begin_prim({.type = "Xform", .name = "tile", .kind = "component", .custom_data = tile_data(tile, header)});
  for (int i = 0; i < static_cast<int>(Layer::kCount); ++i) write_layer(b, static_cast<Layer>(i));
  write_materials(b);
  write_feature_table(b);
  writer->end_prim();
  return {writer->finish(), std::move(b.textures), b.bounds};
}

}  // namespace citykiln::exporters
