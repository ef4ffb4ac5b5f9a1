// The tree of tiles of a scene before anything is baked: what its contents are made of, bounds of their errors, and
// their boxes. From it come both the files of --emit 3dtiles and what a server bakes on request.
//
// An inner node (Q, height, x, y) is joined from tiles of the scene, baked at 3/4 of the node's tolerance, if that is
// at most kCoarsest_m; else from its children's tiles. Nodes of height 1 are always joined from baked tiles.
//
//     Q2_0_0.glb          an inner node
//     └ Q1_0_0.glb        an inner node above up to four tiles of the scene
//       └ 3_-2_L4.glb     a tile of the scene, at the coarsest level; each finer level is the only child
//         └ ... L0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "compiler/bake_scene.h"
#include "compiler/outputs/tiles3d/tree_world.h"
#include "compiler/spec.h"
#include "exporters/tiles3d/quadtree.h"
#include "exporters/tiles3d/tileset.h"

namespace citykiln::outputs {

/// How the inner tiles of one height are made.
struct InnerLevel {
  double tolerance_m = 0;        ///< Twice that of the level below.
  std::optional<double> bake_m;  ///< Tolerance of the tiles that it is joined from; empty: joined from child nodes.
};

/// Shares of an inner level's tolerance:
/// - kBakeShare: the tolerance at which the tiles of a node are baked; at most kCoarsest_m.
/// - kSimplifyShare: the largest error of simplifying the joined terrain. Nodes that are joined from child nodes also
///   lose all plants, and the objects within this distance of the terrain (bake::drop_near_terrain()).
/// - kFadeShare: the largest distance by which roads become ground (bake::fade_roads()); nodes joined from child nodes
///   only.
inline constexpr double kBakeShare = 0.75, kSimplifyShare = 0.25, kFadeShare = 0.125;

/// An inner node of the tree.
struct InnerNode {
  std::vector<exporters::NodeKey> children;  ///< In the order of their last chunks.
  std::vector<std::size_t> chunks;           ///< All chunks below, ascending.
};

/// The origin of a content: a tile of the scene at a level, or an inner node.
struct ContentOrigin {
  std::optional<ChunkLevel> of_tile{};  ///< Empty: of a node.
  exporters::NodeKey node{};
};

struct TreePlan {
  exporters::Quadtree tree{};
  std::size_t own_levels = 0;       ///< The number of levels that are contents of tiles.
  std::vector<InnerLevel> inner{};  ///< By height, from 1.
  std::vector<double> levels_m{};   ///< Tolerances of all levels that are baked: own ones, then those for inner tiles.
  std::map<exporters::NodeKey, InnerNode> nodes{};
  std::map<std::string, ContentOrigin> contents{};  ///< By the name of the content.
  exporters::TilesetTile root{};

  const InnerLevel& inner_level(int height) const { return inner[static_cast<std::size_t>(height) - 1]; }
};

/// Plans the tree of a scene with chunks. Bounds hold for every content; the error of each tile is larger than the
/// errors of its children. O(recipes · levels), about a thousandth of baking.
TreePlan plan_tree(const scene::Scene& scene, const Outputs& outputs, const TreeWorld& world);

/// Returns the name of a content: "3_-2_L0.glb", "Q2_0_0.glb".
std::string content_name(scene::TileKey tile, std::size_t level);
std::string content_name(exporters::NodeKey node);

}  // namespace citykiln::outputs
