#include "compiler/outputs/tiles3d/plan_tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "compiler/bake/cells/tile_bounds.h"
#include "compiler/contract/system/for_each_slot.h"
#include "compiler/contract/tolerance.h"

namespace citykiln::outputs {
namespace {

using bake::Bounds;
using exporters::NodeKey;
using exporters::TilesetTile;

std::vector<InnerLevel> inner_levels(double coarsest_m, int height) {
  std::vector<InnerLevel> all;
  for (int h = 1; h <= height; ++h) {
    const double tolerance_m = 2 * (h == 1 ? coarsest_m : all.back().tolerance_m), bake_m = kBakeShare * tolerance_m;
    if (h == 1)
      all.push_back({tolerance_m, std::min(bake_m, kCoarsest_m)});
    else
      all.push_back({tolerance_m, bake_m <= kCoarsest_m ? std::optional(bake_m) : std::nullopt});
  }
  return all;
}

std::vector<double> all_levels_m(std::vector<double> tolerances_m, std::span<const InnerLevel> inner) {
  for (const InnerLevel& level : inner)
    if (level.bake_m && *level.bake_m > tolerances_m.back()) tolerances_m.push_back(*level.bake_m);
  return tolerances_m;
}

void add_nodes(const scene::Scene& scene, TreePlan& plan) {
  for (std::size_t chunk = 0; chunk < scene.chunks.size(); ++chunk) {
    NodeKey key = exporters::leaf_of(plan.tree, scene.chunks[chunk].tile);
    while (key != plan.tree.root) {
      const NodeKey above = exporters::parent_of(key);
      std::vector<NodeKey>& children = plan.nodes[above].children;
      // a child moves to the end with each of its chunks
      std::erase(children, key);
      children.push_back(key);
      plan.nodes[above].chunks.push_back(chunk);
      key = above;
    }
  }
}

Bounds joined(const Bounds& a, const Bounds& b) {
  Bounds both = a;
  both.plan.grow(b.plan.min), both.plan.grow(b.plan.max);
  both.low_m = std::min(a.low_m, b.low_m), both.high_m = std::max(a.high_m, b.high_m);
  return both;
}

Bounds widened(Bounds bounds, double by_m) {
  return {bounds.plan.widened(by_m), bounds.low_m - by_m, bounds.high_m + by_m};
}

/// The largest things and lamps of a chunk; those that are drawn when it is baked are smaller than the first values.
bake::InstanceSize largest_instance(const scene::Chunk& chunk) {
  bake::InstanceSize largest{8, 16};
  for (const things::Thing& thing : chunk.things) {
    largest.across_m = std::max(largest.across_m, length(Vec2{thing.form.width_m, thing.form.depth_m}) / 2);
    largest.high_m = std::max(largest.high_m, thing.form.height_m);
  }
  for (const props::Lamp& lamp : chunk.lamps) largest.high_m = std::max(largest.high_m, lamp.height_m);
  return largest;
}

/// Plans the tiles of the tree from the leaves up.
class Planner {
 public:
  Planner(const scene::Scene& scene, Compression compression, const TreeWorld& world, TreePlan& plan)
      : scene_(scene), compression_(compression), world_(world), plan_(plan) {
    bounds_ = for_each_slot<std::vector<Bounds>>(scene.chunks.size(), 0, [&](std::size_t i) {
      std::vector<Bounds> of_levels;
      for (const double tolerance_m : plan.levels_m)
        of_levels.push_back(bake::tile_bounds(scene.header, scene.chunks[i], tolerance_m));
      return of_levels;
    });
    for (const scene::Chunk& chunk : scene.chunks) {
      const bake::InstanceSize own = largest_instance(chunk);
      largest_ = {std::max(largest_.across_m, own.across_m), std::max(largest_.high_m, own.high_m)};
    }
  }

  TilesetTile tile_of(NodeKey key) {
    if (key.height == 0) return chain_of(chunk_at(key));
    Shape shape = shape_of(key);
    TilesetTile tile = tile_with(content_name(key), plan_.inner_level(key.height).tolerance_m, shape);
    plan_.contents[tile.content] = {std::nullopt, key};
    for (const NodeKey child : plan_.nodes.at(key).children) add_child(tile, tile_of(child));
    return tile;
  }

 private:
  /// The shape of a content in the plane, as far as it is known.
  struct Shape {
    Bounds bounds;
    double error_m = 0;
  };

  std::size_t chunk_at(NodeKey leaf) const {
    const scene::TileKey tile{leaf.x + plan_.tree.first.x, leaf.y + plan_.tree.first.y};
    return static_cast<std::size_t>(std::ranges::find(scene_.chunks, tile, &scene::Chunk::tile) -
                                    scene_.chunks.begin());
  }

  const Bounds& bounds_at(std::size_t chunk, double tolerance_m) const {
    return bounds_[chunk]
                  [static_cast<std::size_t>(std::ranges::find(plan_.levels_m, tolerance_m) - plan_.levels_m.begin())];
  }

  Shape shape_of(NodeKey key) const {
    const InnerLevel& level = plan_.inner_level(key.height);
    const InnerNode& node = plan_.nodes.at(key);
    const double simplify_m = kSimplifyShare * level.tolerance_m;
    if (level.bake_m) {
      Bounds all = bounds_at(node.chunks.front(), *level.bake_m);
      for (const std::size_t chunk : node.chunks) all = joined(all, bounds_at(chunk, *level.bake_m));
      return {widened(all, simplify_m), *level.bake_m + simplify_m};
    }
    Shape shape = shape_of(node.children.front());
    for (const NodeKey child : node.children) shape.bounds = joined(shape.bounds, shape_of(child).bounds);
    // near objects are dropped, roads fade, terrain is decimated
    return {widened(shape.bounds, simplify_m), shape.error_m + 2 * simplify_m + kFadeShare * level.tolerance_m};
  }

  TilesetTile tile_with(std::string content, double tolerance_m, const Shape& shape) const {
    return {.box = world_.box_of(shape.bounds),
            .error_m = world_.error_bound_m(shape.error_m, tolerance_m, shape.bounds, largest_, compression_),
            .content = std::move(content),
            .tolerance_m = tolerance_m};
  }

  /// Errors fall strictly, though two bounds may be equal.
  static void add_child(TilesetTile& tile, TilesetTile&& child) {
    constexpr double kLeastRatio = 1 + 0x1p-10;
    tile.box.grow(child.box);
    tile.box.round_outwards();
    tile.error_m = std::max(tile.error_m, child.error_m * kLeastRatio);
    tile.children.push_back(std::move(child));
  }

  /// The levels of a tile, the coarsest first, each the only child of the one before.
  TilesetTile chain_of(std::size_t chunk) {
    std::optional<TilesetTile> chain;
    for (std::size_t level = 0; level < plan_.own_levels; ++level) {
      const double tolerance_m = plan_.levels_m[level];
      TilesetTile tile =
          tile_with(content_name(scene_.chunks[chunk].tile, level), tolerance_m, {bounds_[chunk][level], tolerance_m});
      plan_.contents[tile.content] = {ChunkLevel{chunk, level}};
      if (chain) add_child(tile, std::move(*chain));
      chain = std::move(tile);
    }
    return std::move(*chain);
  }

  const scene::Scene& scene_;
  Compression compression_;
  const TreeWorld& world_;
  TreePlan& plan_;
  std::vector<std::vector<Bounds>> bounds_;  ///< By chunk and level.
  bake::InstanceSize largest_;
};

}  // namespace

TreePlan plan_tree(const scene::Scene& scene, const Outputs& outputs, const TreeWorld& world) {
  TreePlan plan{.tree = exporters::quadtree_of(scene.header, scene.chunks), .own_levels = outputs.tolerances_m.size()};
  plan.inner = inner_levels(outputs.tolerances_m.back(), plan.tree.root.height);
  plan.levels_m = all_levels_m(outputs.tolerances_m, plan.inner);
  add_nodes(scene, plan);
  plan.root = Planner(scene, compression_of(outputs, Target::kCesium), world, plan).tile_of(plan.tree.root);
  return plan;
}

std::string content_name(scene::TileKey tile, std::size_t level) {
  return fmt::format("{}_L{}.glb", to_string(tile), level);
}

std::string content_name(NodeKey node) { return fmt::format("Q{}_{}_{}.glb", node.height, node.x, node.y); }

}  // namespace citykiln::outputs
