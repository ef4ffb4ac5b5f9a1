#include "compiler/commands/view/tile_tree.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "compiler/geometry/box.h"
#include "compiler/geometry/snap.h"

namespace citykiln::commands {
namespace {

bool is_shown(const TileNode& node, const std::function<bool(const TileNode&)>& is_fine) {
  return !node.path.empty() && (node.children.empty() || is_fine(node));
}

bool is_over(const exporters::OrientedBox& box, Vec2 place) {
  if (box.is_empty()) return false;
  std::vector<Vec2> corners;
  for (unsigned i = 0; i < 8; ++i) corners.push_back(in_plan(box.corner(i)));
  return box_of(corners).contains(place);
}

void add_finest_at(const TileNode& node, Vec2 place, std::vector<std::string>& paths) {
  if (!is_over(node.box, place)) return;
  if (node.children.empty() && !node.path.empty()) paths.push_back(node.path);
  for (const TileNode& child : node.children) add_finest_at(child, place, paths);
}

void add_contents(const TileNode& node, const std::function<bool(const TileNode&)>& is_fine,
                  std::vector<std::string>& paths) {
  if (is_shown(node, is_fine)) return paths.push_back(node.path);
  for (const TileNode& child : node.children) add_contents(child, is_fine, paths);
}

}  // namespace

double distance_m(const exporters::OrientedBox& box, Vec3 place) {
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double along = dot(box.axes[i], place);
    const double beyond = std::max({box.low[i] - along, along - box.high[i], 0.0});
    sum += beyond * beyond;
  }
  return std::sqrt(sum);
}

bool is_fine_for(const Viewers& viewers, const TileNode& node) {
  assert(!viewers.eyes.empty() && viewers.focal_px > 0 && viewers.pixel_error > 0);
  return std::ranges::all_of(viewers.eyes, [&](Vec3 eye) {
    return node.error_m * viewers.focal_px <= viewers.pixel_error * distance_m(node.box, eye);
  });
}

std::vector<std::string> contents_of(const TileNode& root, const std::function<bool(const TileNode&)>& is_fine) {
  std::vector<std::string> paths;
  add_contents(root, is_fine, paths);
  return paths;
}

std::vector<std::string> finest_contents_at(const TileNode& root, Vec2 place) {
  std::vector<std::string> paths;
  add_finest_at(root, place, paths);
  return paths;
}

}  // namespace citykiln::commands
