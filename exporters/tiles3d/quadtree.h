// The quadtree over the tiles of a scene, from which the 3D Tiles tree is built.
#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <span>

#include "compiler/scene/scene.h"

namespace citykiln::exporters {

/// A node of the tree, which contains the tiles whose numbers, counted from Quadtree::first and divided by 2^height,
/// are x and y. A node of height 0 is one tile.
struct NodeKey {
  int height = 0;
  std::int32_t x = 0, y = 0;
  auto operator<=>(const NodeKey&) const = default;
};

NodeKey parent_of(NodeKey key);

/// The tree: its root, and its inner nodes that have tiles.
struct Quadtree {
  scene::TileKey first;                     ///< The least x and the least y of all tiles of the extent.
  NodeKey root;                             ///< The lowest node that holds all tiles of the extent.
  std::map<NodeKey, std::size_t> children;  ///< For each inner node, the number of children that have tiles: 1 to 4.
};

/// Builds the tree. Its root and numbering depend on the extent in the header, not on which of its tiles exist.
/// @param tiles  The tiles that exist, not empty.
Quadtree quadtree_of(const scene::Header& header, std::span<const scene::Chunk> tiles);

NodeKey leaf_of(const Quadtree& tree, scene::TileKey tile);

/// Returns the square of the plane that a node covers, in metres.
Box2 box_of(const Quadtree& tree, const scene::Header& header, NodeKey key);

}  // namespace citykiln::exporters
