// Finds the places where buildings stand in or beside a road, in the road's coordinates: distance along it, and
// distance from its middle.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/geometry/box_grid.h"
#include "compiler/map/features.h"
#include "compiler/roads/generate.h"
#include "compiler/roads/recipe.h"

namespace citykiln::roads {

/// Distances along a road are counted in steps of kStep_m, distances from its middle in units of kUnit_m. A limit that
/// changes by one unit per step has the slope kTaper.
inline constexpr double kStep_m = 0.25, kUnit_m = 0x1p-5;

/// The limit that a building sets to the road's edge at one step.
struct Obstacle {
  std::int32_t at_steps = 0;    ///< Distance from the beginning of the whole way.
  std::int16_t half_units = 0;  ///< Largest distance of the road's edge from its middle, in units of kUnit_m.
  bool is_left = false;
  auto operator<=>(const Obstacle&) const = default;
};

/// The obstacles of one road.
struct BuildingObstacles {
  std::vector<Obstacle> obstacles;  ///< Only limits inside the road's full width.
  /// Sorted steps at which a building covers the road, as the axis runs into or through it.
  std::vector<std::int32_t> covered;
};

/// A building obstructs a road if the clearance below it is less than this: the height of the lowest habitable storey.
inline constexpr double kHeadroom_m = 2.5;

/// Where a road's axis runs into or through a building (a passage, a gate, an imprecise way), that building does not
/// limit the road within this distance. It is half the width of a wide street, so that a wall at 45 degrees is ignored.
inline constexpr double kPassage_m = 12;

/// An index of the footprints that can obstruct roads. Refers to the footprints, which must outlive it. Construction
/// O(n log n).
class ObstructingFootprints {
 public:
  explicit ObstructingFootprints(std::span<const map::Footprint> footprints);

  /// Returns the indices of footprints whose boxes touch a box, sorted.
  std::vector<std::uint32_t> near(const Box2& box) const;
  const Polygon& operator[](std::uint32_t index) const { return footprints_[index].polygon; }

 private:
  std::span<const map::Footprint> footprints_;
  std::vector<std::uint32_t> indices_;  // of the footprints that obstruct, with their boxes
  std::vector<Box2> boxes_;
  BoxGrid grid_;
};

/// Returns all obstacles in the strip of a road, pavements and bends included. A road edge that runs straight between
/// the limits of neighbouring steps stays out of the building. O(edges of the footprints near each segment).
/// @param ends  Connections to other roads at both ends.
BuildingObstacles find_building_obstacles(const Road& road, const StripEnds& ends,
                                          const ObstructingFootprints& footprints);

}  // namespace citykiln::roads
