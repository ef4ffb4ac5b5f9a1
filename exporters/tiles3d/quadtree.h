// The quadtree over the tiles of a scene.
#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <span>

#include "compiler/scene/scene.h"

namespace citykiln::exporters {

/// A node: all tiles whose numbers from the region's first tile, divided by 2^height, are x and y. Height 0 is a tile.
struct NodeKey {
  int height = 0;
  std::int32_t x = 0, y = 0;
  auto operator<=>(const NodeKey&) const = default;
};

NodeKey parent_of(NodeKey key);

/// The nodes that have tiles.
struct Quadtree {
  scene::TileKey first;                     ///< Of the region: the least x and the least y.
  NodeKey root;                             ///< The lowest node that holds all tiles of the region.
  std::map<NodeKey, std::size_t> children;  ///< Of each inner node: how many have tiles, 1 to 4.
};

/// @param tiles  Those that there are, not empty. The nodes depend on the header's region, not on which tiles of it
/// there are.
Quadtree quadtree_of(const scene::Header& header, std::span<const scene::Chunk> tiles);

NodeKey leaf_of(const Quadtree& tree, scene::TileKey tile);

/// The node's square of the plane.
Box2 box_of(const Quadtree& tree, const scene::Header& header, NodeKey key);

}  // namespace citykiln::exporters
