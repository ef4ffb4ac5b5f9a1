#include "exporters/tiles3d/quadtree.h"

#include <algorithm>
#include <cassert>
#include <set>

namespace citykiln::exporters {

NodeKey parent_of(NodeKey key) { return {key.height + 1, key.x / 2, key.y / 2}; }

NodeKey leaf_of(const Quadtree& tree, scene::TileKey tile) { return {0, tile.x - tree.first.x, tile.y - tree.first.y}; }

Quadtree quadtree_of(const scene::Header& header, std::span<const scene::Chunk> tiles) {
  assert(!tiles.empty());
  const std::vector<scene::TileKey> all = scene::tiles_of(header);
  Quadtree tree{all.front(), {}, {}};
  for (const scene::TileKey tile : all) tree.first = {std::min(tree.first.x, tile.x), std::min(tree.first.y, tile.y)};
  std::int32_t most = 0;
  for (const scene::TileKey tile : all) most = std::max({most, tile.x - tree.first.x, tile.y - tree.first.y});
  while ((most >> tree.root.height) > 0) ++tree.root.height;

  std::map<NodeKey, std::set<NodeKey>> children;
  for (const scene::Chunk& chunk : tiles)
    for (NodeKey key = leaf_of(tree, chunk.tile); key.height < tree.root.height; key = parent_of(key))
      children[parent_of(key)].insert(key);
  for (const auto& [key, below] : children) tree.children[key] = below.size();
  return tree;
}

Box2 box_of(const Quadtree& tree, const scene::Header& header, NodeKey key) {
  const double side_m = header.tile_m * static_cast<double>(std::int64_t{1} << key.height);
  const Vec2 low = Vec2{static_cast<double>(tree.first.x), static_cast<double>(tree.first.y)} * header.tile_m +
                   Vec2{static_cast<double>(key.x), static_cast<double>(key.y)} * side_m;
  return {low, low + Vec2{side_m, side_m}};
}

}  // namespace citykiln::exporters
