#include "compiler/plants/placing/tree_clearance.h"

#include <algorithm>
#include <vector>

namespace citykiln::plants {

double crown_clearance_m(const SpeciesValues& species, double height_m) {
  constexpr double kRoom_m = 1.5, kLeast_m = 2;
  return std::clamp(species.crown_share * height_m / 2 + kRoom_m, kLeast_m, kMostClearance_m);
}

TreeClearanceIndex index_tree_clearances(std::span<const TreeClearance> all) {
  constexpr double kBucket_m = 16;
  std::vector<Box2> boxes;
  for (const TreeClearance& o : all) boxes.push_back(Box2{o.at, o.at}.widened(o.radius_m));
  return {all, grid_of(boxes, kBucket_m)};
}

bool is_near_tree(const TreeClearanceIndex& trees, Vec2 p) {
  return std::ranges::any_of(boxes_about(trees.grid, p),
                             [&](std::uint32_t i) { return distance(trees.all[i].at, p) < trees.all[i].radius_m; });
}

}  // namespace citykiln::plants
