// Obstacles: places of buildings beside a road, in the road's coordinates (distance along it, distance from its
// middle).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/geometry/box_grid.h"
#include "compiler/map/features.h"
#include "compiler/roads/generate.h"
#include "compiler/roads/recipe.h"

namespace citykiln::roads {

/// Distances along a road are counted in steps of kStep_m, and widths in units of kUnit_m, so kTaper is one unit a
/// step.
inline constexpr double kStep_m = 0.25, kUnit_m = 0x1p-5;

/// The limit that a building sets to the road's edge at one step.
struct Obstacle {
  std::int32_t at_steps = 0;  ///< Distance from the beginning of the whole way.
  std::int16_t half_units = 0;
  bool is_left = false;
  auto operator<=>(const Obstacle&) const = default;
};

struct BuildingObstacles {
  std::vector<Obstacle> obstacles;  ///< Only limits inside the road's full width.
  std::vector<std::int32_t>
      covered;  ///< Sorted steps at which a building covers the road, as the axis runs into or through it.
};

/// Buildings with less clearance below them than this obstruct a road: the height of the lowest habitable storey.
inline constexpr double kHeadroom_m = 2.5;

/// A building that an axis runs into or through (a passage, a gate, an imprecise way) does not limit that road within
/// this distance of the place. It is half the width of a wide street, so that a wall at 45 degrees is ignored.
inline constexpr double kPassage_m = 12;

/// Index of the footprints that obstruct roads. Refers to the footprints. Construction O(n log n).
class StandingFootprints {
 public:
  explicit StandingFootprints(std::span<const map::Footprint> footprints);

  /// Returns the indices of footprints whose boxes touch a box, sorted.
  std::vector<std::uint32_t> near(const Box2& box) const;
  const Polygon& operator[](std::uint32_t index) const { return footprints_[index].polygon; }

 private:
  std::span<const map::Footprint> footprints_;
  std::vector<std::uint32_t> indices_;  // of the footprints that obstruct, with their boxes
  std::vector<Box2> boxes_;
  BoxGrid grid_;
};

/// Returns all obstacles in the strip of a road, pavements and bends included. An edge that keeps to the limits of two
/// neighbouring steps and runs straight between them stays out of the building. O(edges of the footprints near each
/// segment).
BuildingObstacles find_building_obstacles(const Road& road, const StripEnds& ends,
                                          const StandingFootprints& footprints);

}  // namespace citykiln::roads
