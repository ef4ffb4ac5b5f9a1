// Obstacles: buildings beside a road, in the road's coordinates (distance along it, distance from its middle).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/geometry/box_grid.h"
#include "compiler/map/features.h"
#include "compiler/roads/generate.h"
#include "compiler/roads/recipe.h"

namespace citykiln::roads {

/// Distances along a road are whole steps and widths whole units, so that kTaper is one unit a step.
inline constexpr double kStep_m = 0.25, kUnit_m = 0x1p-5;

/// A limit at one step: a building lets the road's edge go no farther out.
struct Obstacle {
  std::int32_t at_steps = 0;  ///< From the beginning of the whole way.
  std::int16_t half_units = 0;
  bool is_left = false;
  auto operator<=>(const Obstacle&) const = default;
};

struct BuildingObstacles {
  std::vector<Obstacle> obstacles;  ///< Only where it limits the road's own edge.
  std::vector<std::int32_t>
      covered;  ///< Sorted steps at which a building covers the road because the axis runs into or through it.
};

/// Buildings with less clearance than this obstruct a road: the lowest habitable storey.
inline constexpr double kHeadroom_m = 2.5;

/// A building that an axis runs into or through (a passage, a gate, an imprecise way) does not limit that road within
/// this distance: half a wide street, so that a wall at 45 degrees is ignored.
inline constexpr double kPassage_m = 12;

/// Footprints that obstruct roads, in a grid of buckets. Refers to the footprints. O(n log n).
class StandingFootprints {
 public:
  explicit StandingFootprints(std::span<const map::Footprint> footprints);

  /// Returns the indices of footprints whose boxes touch, sorted.
  std::vector<std::uint32_t> near(const Box2& box) const;
  const Polygon& operator[](std::uint32_t index) const { return footprints_[index].polygon; }

 private:
  std::span<const map::Footprint> footprints_;
  std::vector<std::uint32_t> indices_;  // of the footprints that obstruct, with their boxes
  std::vector<Box2> boxes_;
  BoxGrid grid_;
};

/// Returns all obstacles in the strip of a road, pavements and bends included. Between two steps, an edge that keeps to
/// both limits and runs straight stays out of the building.
///
/// Total. O(edges of the footprints near each segment).
BuildingObstacles find_building_obstacles(const Road& road, const StripEnds& ends,
                                          const StandingFootprints& footprints);

}  // namespace citykiln::roads
