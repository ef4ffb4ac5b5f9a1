#include "compiler/lots/plant_yard.h"

#include <algorithm>
#include <cmath>

#include "compiler/geometry/segment.h"
#include "compiler/geometry/snap.h"

namespace citykiln::lots {
namespace {

constexpr double kSquare_m = 4, kMostMoved_m = 1.2;
constexpr double kTreeToWall_m = 3, kShrubToWall_m = 2, kToWay_m = 1, kToBorder_m = 0.75, kToTree_m = 2;
// Shrubs of gardens, as they are kept.
constexpr double kLeastShrub_m = 0.75, kHighestShrub_m = 1.75;

// Draws of one square: their first index follows from the square, within the lot.
constexpr std::uint32_t kDraws = 4, kFirstDraw = 16;

struct Planter {
  const Lot& lot;
  const YardRule& rule;
  std::span<const map::Barrier> barriers;
  const BorderObstacles& obstacles;

  map::LandCoverClass surface_at(Vec2 p) const {
    const bool is_front = rule.front != rule.rear && lot.frame.local(p).y <= lot.setback_m;
    return is_front ? rule.front : rule.rear;
  }

  bool is_off_ways(Vec2 p) const {
    const MappedThings& mapped = obstacles.mapped;
    for (const Capsules* ways : {&mapped.roads, &mapped.paths, &mapped.drives, &obstacles.openings})
      if (clearance_m(*ways, p, kToWay_m) < kToWay_m) return false;
    return true;
  }

  bool is_off_barriers(Vec2 p) const {
    return clearance_m(obstacles.mapped.barriers, p, kToBorder_m) >= kToBorder_m &&
           std::ranges::none_of(barriers, [&](const map::Barrier& barrier) {
             return distance_to_polyline(barrier.axis, p) < kToBorder_m;
           });
  }

  bool is_place(Vec2 p, bool is_shrub) const {
    const MappedThings& mapped = obstacles.mapped;
    const double to_wall_m = is_shrub ? kShrubToWall_m : kTreeToWall_m;
    return contains(lot.parcel.polygon, p) && is_planted(surface_at(p)) &&
           distance_to_ring(lot.parcel.polygon.outer, p) >= kToBorder_m &&
           clearance_m(mapped.walls, p, to_wall_m) >= to_wall_m && !is_inside_any(mapped.buildings, p) &&
           !is_inside_any(mapped.pools, p) && is_off_ways(p) && is_off_barriers(p) &&
           clearance_m(mapped.wires, p, 0.25) > 0 && clearance_m(mapped.junction_zones, p, 0.25) > 0 &&
           !is_inside_any(mapped.corners, p) && clearance_m(mapped.trees, p, kToTree_m) >= kToTree_m;
  }

  bool has_mapped_tree() const {
    const Capsules& trees = obstacles.mapped.trees;
    return !trees.all.empty() &&
           std::ranges::any_of(boxes_about(trees.grid, box_of(lot.parcel.polygon.outer)), [&](std::uint32_t i) {
             return contains(lot.parcel.polygon, trees.all[i].a) || contains(lot.parcel.polygon, trees.all[i].b);
           });
  }
};

// A number of a square that does not depend on the lot's extent.
std::uint32_t draw_index(std::int64_t column, std::int64_t row) {
  const auto square = static_cast<std::uint32_t>((column & 0x3fff) << 14 | (row & 0x3fff));
  return kFirstDraw + kDraws * square;
}

}  // namespace

std::vector<YardPlant> plants_of(const Lot& lot, const YardRule& rule, std::span<const map::Barrier> barriers,
                                 const BorderObstacles& obstacles, const RandomSequence& draw) {
  std::vector<YardPlant> plants;
  const double per_square = (rule.trees + rule.shrubs) * kSquare_m * kSquare_m / 100;
  if (per_square <= 0) return plants;
  const Planter planter{lot, rule, barriers, obstacles};
  const bool has_tree = planter.has_mapped_tree();
  const Box2 box = box_of(lot.parcel.polygon.outer);
  const auto first = [](double v) { return static_cast<std::int64_t>(std::floor(v / kSquare_m)); };
  for (std::int64_t row = first(box.min.y); row <= first(box.max.y); ++row)
    for (std::int64_t column = first(box.min.x); column <= first(box.max.x); ++column) {
      const std::uint32_t index = draw_index(column, row);
      const double kept = draw.unit(index);
      if (kept >= per_square || plants.size() >= kMostPlants) continue;
      const bool is_shrub = kept >= rule.trees * kSquare_m * kSquare_m / 100;
      const Vec2 moved{draw.between(-kMostMoved_m, kMostMoved_m, index + 1),
                       draw.between(-kMostMoved_m, kMostMoved_m, index + 2)};
      const Vec2 at = snapped(
          Vec2{(static_cast<double>(column) + 0.5) * kSquare_m, (static_cast<double>(row) + 0.5) * kSquare_m} + moved);
      if ((!is_shrub && has_tree) || !planter.is_place(at, is_shrub)) continue;
      const double height_m = is_shrub ? draw.between(kLeastShrub_m, kHighestShrub_m, index + 3) : 0;
      plants.push_back({at, is_shrub, std::floor(height_m * 8) / 8});
    }
  return plants;
}

}  // namespace citykiln::lots
