// A tree of tiles at several levels of detail: the children of a node show the same place as the node, more finely.
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
  exporters::OrientedBox box{};  ///< Of what the tile and its children show, metres.
  double error_m = 0;            ///< Of its content. Stated, >= 0.
  std::string path{};            ///< Of its content, a .glb; empty: none, its children are shown.
  std::vector<TileNode> children{};
};

/// Those who look at a tree: the nearest counts.
struct Viewers {
  std::vector<Vec3> eyes;  ///< In the frame of the tree. Not empty.
  double focal_px = 0;     ///< > 0.
  double pixel_error = 0;  ///< The longest error in a picture. > 0.
};

/// The distance from a point to a box; 0 inside, infinite for an empty box.
double distance_m(const exporters::OrientedBox& box, Vec3 place);

/// Whether an error is not longer than the viewers' pixel error at the nearest point of the node's box.
bool is_fine_for(const Viewers& viewers, const TileNode& node);

/// The contents that show the whole tree once, by their paths in the tree's order: of every branch the first node from
/// its root that is fine enough, or its last one. O(nodes).
std::vector<std::string> contents_of(const TileNode& root, const std::function<bool(const TileNode&)>& is_fine);

/// The contents of the last nodes whose boxes are above or below a place.
std::vector<std::string> finest_contents_at(const TileNode& root, Vec2 place);

}  // namespace citykiln::commands
