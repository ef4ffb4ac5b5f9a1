#include "exporters/usd/encode_level.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>

#include "exporters/usd/crate_writer.h"
#include "exporters/usd/text_writer.h"
#include "exporters/usd/usd_features.h"
#include "exporters/usd/usd_materials.h"
#include "exporters/usd/usd_meshes.h"

namespace citykiln::exporters {
namespace {

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

std::string usd_attribution(const scene::Header& header) {
  return fmt::format("{}", fmt::join(header.attributions, "; "));
}

UsdLevel encode_level(const bake::BakedTile& tile, const scene::Header& header, const std::string& texture_folder,
                      UsdForm form) {
  const auto writer =
      writer_of(form, {.default_prim = "tile", .custom_data = {{"attribution", usd_attribution(header)}}});
  UsdBuilder b{.tile = tile, .writer = *writer, .texture_folder = texture_folder};
  writer->begin_prim({.type = "Xform", .name = "tile", .kind = "component", .custom_data = tile_data(tile, header)});
  for (int i = 0; i < static_cast<int>(Layer::kCount); ++i) write_layer(b, static_cast<Layer>(i));
  write_materials(b);
  write_features(b);
  writer->end_prim();
  return {writer->finish(), std::move(b.textures), b.bounds};
}

}  // namespace citykiln::exporters
