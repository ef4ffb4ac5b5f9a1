// A tree of tiles at several levels of detail, from which the tiles to show are chosen. The children of a node show the
// same place as the node, in more detail.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "compiler/geometry/vec.h"
#include "exporters/tiles3d/oriented_box.h"

namespace citykiln::commands {

/// One tile at one level.
struct TileNode {
  exporters::OrientedBox box{};  ///< The box of the content and of the children, in metres.
  double error_m = 0;            ///< The stated error of the content, >= 0.
  std::string path{};            ///< The path of the content, a .glb; empty: the children are shown instead.
  std::vector<TileNode> children{};
};

/// The viewpoints from which a tree is seen. A tile's level is decided by the viewpoint nearest to the tile.
struct Viewers {
  std::vector<Vec3> eyes;  ///< In the frame of the tree. Not empty.
  double focal_px = 0;     ///< The focal length of the pictures. > 0.
  double pixel_error = 0;  ///< The largest error in a picture. > 0.
};

/// Returns the distance from a point to a box; 0 inside, infinite for an empty box.
double distance_m(const exporters::OrientedBox& box, Vec3 place);

/// True if the node's error, at the nearest point of its box, is at most the viewers' pixel error.
bool is_fine_for(const Viewers& viewers, const TileNode& node);

/// Returns the paths of contents that together show the whole tree once, in the tree's order. On each path from the
/// root to a leaf this is the content of the first node that is fine enough, or of the leaf if none is. O(nodes).
/// @param is_fine  True if a node is fine enough, such as is_fine_for() with some viewers.
std::vector<std::string> contents_of(const TileNode& root, const std::function<bool(const TileNode&)>& is_fine);

/// Returns the paths of the contents of the leaves whose boxes contain a place, seen from above.
std::vector<std::string> finest_contents_at(const TileNode& root, Vec2 place);

}  // namespace citykiln::commands
