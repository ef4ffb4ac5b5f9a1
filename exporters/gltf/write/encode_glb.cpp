#include <fmt/format.h>

#include "compiler/bake/far/bake_surroundings.h"
#include "exporters/file.h"
#include "exporters/gltf/glb.h"
#include "exporters/gltf/glb_names.h"
#include "exporters/gltf/pack/compress_glb.h"
#include "exporters/gltf/pack/quantise.h"
#include "exporters/gltf/write/encode_lights.h"
#include "exporters/gltf/write/encode_nodes.h"
#include "exporters/gltf/write/encode_pictures.h"
#include "exporters/gltf/write/glb_builder.h"
#include "exporters/gltf/write/property_table.h"
#include "exporters/joined_attributions.h"

namespace citykiln::exporters {
namespace {

using bake::BakedTile;
using bake::Primitive;
using Json = nlohmann::json;

// Adds the meaning of the tile's coordinates.
void add_frame(Json& extras, const BakedTile& tile, const scene::Header& header, bool is_on_ellipsoid) {
  if (tile.cylinder) {
    extras["frame"] = {{"projection", "none: inside of a cylinder around the x axis at height radius_m"},
                       {"radius_m", tile.cylinder->radius_m},
                       {"middle_y_m", tile.cylinder->middle_y_m}};
    return;
  }
  extras[is_on_ellipsoid ? "frame" : "plane"] = {
      {"lon_0", header.origin.lon_deg},
      {"lat_0", header.origin.lat_deg},
      {"projection", is_on_ellipsoid ? "none: east, north, up at lon_0, lat_0 on the WGS84 ellipsoid"
                                     : "transverse Mercator, WGS84, scale 1 at the origin"}};
}

Json tile_extras(const BakedTile& tile, const scene::Header& header, const GlbOptions& options) {
  Json extras = {{"tile", {tile.tile.x, tile.tile.y}},  {"origin_m", {tile.origin.x, tile.origin.y, tile.origin.z}},
                 {"tolerance_m", tile.tolerance_m},     {"error_m", tile.error_m},
                 {"plant_error_m", tile.plant_error_m}, {"rounding_m", rounding_m(tile.primitives)}};
  add_frame(extras, tile, header, options.is_on_ellipsoid);
  if (const auto& seen = tile.viewpoint)
    extras["viewpoint"] = {{"eye_m", {seen->eye.x, seen->eye.y, seen->eye.z}},
                           {"focal_px", seen->focal_px},
                           {"pixel_error", seen->pixel_error}};
  return extras;
}

Json root_of(const BakedTile& tile, const scene::Header& header, const GlbOptions& options) {
  const bool is_around = tile.tile == bake::kSurroundingsTile;
  // whole metres, so that tiles imported side by side fit exactly
  return {{"name", is_around ? "surroundings" : fmt::format("tile_{}_{}", tile.tile.x, tile.tile.y)},
          {"translation", {tile.origin.x, tile.origin.z, 0.0 - tile.origin.y}},
          {"extras", tile_extras(tile, header, options)}};
}

void fill(GlbBuilder& f) {
  Json& gltf = f.file.gltf = new_gltf();
  const std::string copyright = joined_attributions(f.header.attributions);
  if (!copyright.empty()) gltf["asset"]["copyright"] = copyright;
  add_nodes(f, root_of(f.tile, f.header, f.options));
  add_lights(f);
  add_pictures(f);
  gltf["extensions"][kMetadataExtension] = property_table(f);
  gltf["extensionsUsed"] = f.extensions;
  if (f.extensions.contains(kWebpExtension)) gltf["extensionsRequired"] = Json::array({kWebpExtension});
}

// An upper bound of the meshes' bytes in the buffer, which is large and should not move while it grows.
std::size_t bytes_of_meshes(const std::vector<Primitive>& primitives) {
  constexpr std::size_t kVertexBytes = 64, kTriangleBytes = 12, kPaddingBytes = 64;
  std::size_t bytes = 0;
  for (const Primitive& p : primitives)
    bytes += p.positions.size() * kVertexBytes + p.triangles.size() * kTriangleBytes + kPaddingBytes;
  return bytes;
}

}  // namespace

GlbParts build_glb(const BakedTile& tile, const scene::Header& header, const GlbOptions& options, int threads) {
  GlbBuilder f{tile, header, options};
  f.file.buffer.reserve(bytes_of_meshes(tile.primitives));
  find_cutouts(f);
  fill(f);
  if (options.compression == Compression::kNone) return std::move(f.file);
  return compressed_glb(std::move(f.file), options.compression, threads);
}

std::vector<std::byte> encode_glb(const BakedTile& tile, const scene::Header& header, const GlbOptions& options,
                                  int threads) {
  return join_glb(build_glb(tile, header, options, threads));
}

Result<Done> write_glb(const BakedTile& tile, const scene::Header& header, const GlbOptions& options,
                       const std::string& path, int threads) {
  return write_file(path, encode_glb(tile, header, options, threads));
}

}  // namespace citykiln::exporters
