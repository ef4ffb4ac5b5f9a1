#include <sstream>

#include "compiler/bake/far/bake_surroundings.h"
#include "exporters/file.h"
#include "exporters/gltf/compress_glb.h"
#include "exporters/gltf/encode_lights.h"
#include "exporters/gltf/encode_nodes.h"
#include "exporters/gltf/encode_pictures.h"
#include "exporters/gltf/glb.h"
#include "exporters/gltf/glb_builder.h"
#include "exporters/gltf/plain_glb.h"
#include "exporters/gltf/property_table.h"
#include "exporters/gltf/quantise.h"
#include "exporters/joined_attributions.h"

namespace citykiln::exporters {
namespace {

using bake::BakedTile;
using bake::Primitive;
using tinygltf::Value;
using Object = Value::Object;
using Array = Value::Array;

Value text(const std::string& s) { return Value(s); }
Value number(double v) { return Value(v); }

Value vector(Vec3 v) { return Value(Array{number(v.x), number(v.y), number(v.z)}); }

// The meaning of the tile's coordinates.
void add_frame(Object& extras, const scene::Header& header, bool is_on_ellipsoid) {
  Object frame = {{"lon_0", number(header.origin.lon_deg)}, {"lat_0", number(header.origin.lat_deg)}};
  frame["projection"] = text(is_on_ellipsoid ? "none: east, north, up at lon_0, lat_0 on the WGS84 ellipsoid"
                                             : "transverse Mercator, WGS84, scale 1 at the origin");
  extras[is_on_ellipsoid ? "frame" : "plane"] = Value(std::move(frame));
}

Value tile_extras(const BakedTile& tile, const scene::Header& header, const GlbOptions& options) {
  Object extras = {{"tile", Value(Array{Value(tile.tile.x), Value(tile.tile.y)})},
                   {"origin_m", vector(tile.origin)},
                   {"tolerance_m", number(tile.tolerance_m)},
                   {"error_m", number(tile.error_m)},
                   {"plant_error_m", number(tile.plant_error_m)},
                   {"rounding_m", number(rounding_m(tile.primitives))}};
  add_frame(extras, header, options.is_on_ellipsoid);
  if (const auto& seen = tile.viewpoint)
    extras["viewpoint"] = Value(Object{{"eye_m", vector(seen->eye)},
                                       {"focal_px", number(seen->focal_px)},
                                       {"pixel_error", number(seen->pixel_error)}});
  return Value(std::move(extras));
}

tinygltf::Node root_of(const BakedTile& tile, const scene::Header& header, const GlbOptions& options) {
  tinygltf::Node root;
  const bool is_around = tile.tile == bake::kSurroundingsTile;
  root.name = is_around ? "surroundings" : "tile_" + std::to_string(tile.tile.x) + "_" + std::to_string(tile.tile.y);
  // whole metres, so that tiles imported side by side fit exactly
  root.translation = {tile.origin.x, tile.origin.z, 0.0 - tile.origin.y};
  root.extras = tile_extras(tile, header, options);
  return root;
}

void fill(GlbBuilder& f) {
  f.model.asset.version = "2.0", f.model.asset.generator = "citykiln 0.1.0",
  f.model.asset.copyright = joined_attributions(f.header.attributions);
  f.model.buffers.emplace_back();
  add_nodes(f, root_of(f.tile, f.header, f.options));
  add_lights(f);
  add_pictures(f);
  f.model.extensions["EXT_structural_metadata"] = property_table(f);
  f.model.extensionsUsed.assign(f.extensions.begin(), f.extensions.end());
  if (f.extensions.contains(kWebpExtension)) f.model.extensionsRequired = {kWebpExtension};
  tinygltf::Scene scene;
  scene.nodes = {0};
  f.model.scenes.push_back(scene);
  f.model.defaultScene = 0;
}

// An upper bound of the meshes' bytes in the buffer, which is large and should not move while it grows.
std::size_t bytes_of_meshes(const std::vector<Primitive>& primitives) {
  constexpr std::size_t kVertexBytes = 64, kTriangleBytes = 12, kPaddingBytes = 64;
  std::size_t bytes = 0;
  for (const Primitive& p : primitives)
    bytes += p.positions.size() * kVertexBytes + p.triangles.size() * kTriangleBytes + kPaddingBytes;
  return bytes;
}

PlainGlb plain_glb(const BakedTile& tile, const scene::Header& header, const GlbOptions& options) {
  GlbBuilder f{tile, header, options};
  f.buffer.reserve(bytes_of_meshes(tile.primitives));
  find_cutouts(f);
  fill(f);
  std::ostringstream out;
  tinygltf::TinyGLTF().WriteGltfSceneToStream(&f.model, out, false, true);
  return {std::move(out).str(), std::move(f.buffer)};
}

}  // namespace

std::vector<std::byte> encode_glb(const BakedTile& tile, const scene::Header& header, const GlbOptions& options,
                                  int threads) {
  if (options.compression == Compression::kNone) return joined_glb(plain_glb(tile, header, options));
  return compressed_glb(plain_glb(quantised(tile), header, options), options.compression, threads);
}

Result<Done> write_glb(const BakedTile& tile, const scene::Header& header, const GlbOptions& options,
                       const std::string& path, int threads) {
  return write_file(path, encode_glb(tile, header, options, threads));
}

}  // namespace citykiln::exporters
