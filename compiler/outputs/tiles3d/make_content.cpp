#include "compiler/outputs/tiles3d/make_content.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "compiler/bake/far/bake_surroundings.h"
#include "compiler/bake/far/fade_roads.h"
#include "compiler/bake/tiles/join_tiles.h"
#include "compiler/bake/tiles/simplify_tile.h"
#include "compiler/outputs/run_report.h"
#include "exporters/gltf/write/encode_tile.h"
#include "exporters/run_files.h"

namespace citykiln::outputs {
namespace {

using exporters::NodeKey;
using exporters::TilesetTile;
using Lights = std::vector<bake::PlacedLamp>;

/// Measuring the error of decimated terrain takes time per square of the tolerance. A tile whose tolerance is a smaller
/// share of its side is not decimated, unless its level has few tiles.
constexpr double kLeastShareOfSide = 1.0 / 512;
constexpr int kFewFromHeight = 3;

bool is_decimated(int height, double tolerance_m, double side_m) {
  return height >= kFewFromHeight || tolerance_m >= kLeastShareOfSide * side_m;
}

/// On the ellipsoid lamps are a few metres high, so that their lean to the vertical of the origin does not matter.
Lights bent(const TreeWorld& world, Lights lights) {
  // those inside of a cylinder are there already
  if (world.cylinder()) return lights;
  for (bake::PlacedLamp& lamp : lights) lamp.placement.at = world.at(lamp.placement.at).at;
  return lights;
}

/// Encodes a tile that is bent already.
exporters::EncodedTile encoded(const TreeContents& tree, bake::BakedTile&& tile, const Lights& lights, int threads) {
  Outputs outputs = tree.outputs;
  outputs.target = Target::kCesium;
  exporters::GlbOptions options = glb_options_of(outputs);
  options.is_on_ellipsoid = !tree.world.cylinder();
  const Lights bent_lights = bent(tree.world, lights);
  options.lights = bent_lights;
  return exporters::encode_tile(std::move(tile), tree.scene.header, options, threads);
}

std::set<scene::TileKey> tiles_below(const TreeContents& tree, NodeKey key) {
  std::set<scene::TileKey> tiles;
  for (const std::size_t chunk : tree.plan.nodes.at(key).chunks) tiles.insert(tree.scene.chunks[chunk].tile);
  return tiles;
}

}  // namespace

std::vector<std::byte> make_content(const TreeContents& tree, bake::BakedTile&& baked, const Lights& lights,
                                    int threads) {
  tree.textures.apply(baked);
  return encoded(tree, tree.world.bent(std::move(baked)), lights, threads).glb;
}

bake::BakedTile make_part(const TreeContents& tree, int height, scene::TileKey tile, bake::BakedTile&& baked) {
  const double simplify_m = kSimplifyShare * tree.plan.inner_level(height).tolerance_m;
  const scene::Header& header = tree.scene.header;
  if (is_decimated(height, simplify_m, std::ldexp(header.tile_m, height)))
    bake::simplify_terrain(baked, scene::box_of(header, tile), simplify_m);
  return std::move(baked);
}

Result<bake::BakedTile> make_inner_tile(const TreeContents& tree, NodeKey key, std::span<const bake::BakedTile> parts) {
  Result<bake::BakedTile> joined = bake::join_tiles(parts, bake::JoinPrecision::kRounded);
  if (!joined) return joined;
  const InnerLevel& level = tree.plan.inner_level(key.height);
  joined->tolerance_m = level.tolerance_m;
  bake::remove_inner_skirts(*joined, tiles_below(tree, key), tree.scene.header.tile_m);
  if (!level.bake_m) {
    const double simplify_m = kSimplifyShare * level.tolerance_m;
    bake::drop_near_terrain(*joined, simplify_m);
    bake::fade_roads(*joined, kFadeShare * level.tolerance_m);
    const Box2 square = exporters::box_of(tree.plan.tree, tree.scene.header, key);
    if (is_decimated(key.height, simplify_m, square.width())) bake::simplify_terrain(*joined, square, simplify_m);
  }
  bake::drop_unused_features(*joined);
  return joined;
}

std::optional<AroundContent> make_surroundings(const TreeContents& tree, int threads) {
  std::optional<bake::BakedTile> baked = bake::bake_surroundings(tree.scene, bake::EarthCurve::kNone);
  if (!baked) return std::nullopt;
  tree.textures.apply(*baked);
  bake::BakedTile bent_tile = tree.world.bent(std::move(*baked));
  AroundContent around{
      .glb = {},
      .tile = {.box = exporters::box_of(bent_tile, tree.world.axes_at(tree.scene.header.extent.centre())),
               .content = exporters::kSurroundingsContent,
               .tolerance_m = bent_tile.tolerance_m}};
  exporters::EncodedTile content = encoded(tree, std::move(bent_tile), {}, threads);
  around.glb = std::move(content.glb), around.tile.error_m = content.error_m;
  return around;
}

TilesetTile with_surroundings(TilesetTile root, TilesetTile around) {
  TilesetTile both;
  both.box = root.box;
  both.box.grow(around.box);
  both.box.round_outwards();
  both.error_m = 2 * std::max(root.error_m, around.error_m);
  both.children = {std::move(root), std::move(around)};
  return both;
}

}  // namespace citykiln::outputs
