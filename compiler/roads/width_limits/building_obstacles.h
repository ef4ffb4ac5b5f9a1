// Where buildings stand beside a road, in the road's own coordinates: how far along it, how far from its middle.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/geometry/box.h"
#include "compiler/map/features.h"
#include "compiler/roads/generate.h"
#include "compiler/roads/recipe.h"

namespace citykiln::roads {

/// Distances along a road are whole steps, widths whole units: a taper is one unit a step.
inline constexpr double kStep_m = 0.25, kUnit_m = 0x1p-5;

/// A building lets the road's edge go no farther out.
struct Obstacle {
  std::int32_t at_steps = 0;  ///< From the beginning of the whole way.
  std::int16_t half_units = 0;
  bool is_left = false;
  auto operator<=>(const Obstacle&) const = default;
};

struct BuildingObstacles {
  std::vector<Obstacle> obstacles;    ///< None as far out as the road's own edge.
  std::vector<std::int32_t> covered;  ///< Sorted steps at which a building stands that the axis runs into or through.
};

/// A building with less room than this under it stands in the way: less than the lowest storey that is let.
inline constexpr double kHeadroom_m = 2.5;

/// A building that an axis runs into or through (a passage, a gate, a way drawn carelessly) asks nothing of that road
/// so close to it: half the width of a wide street, so that a wall at 45 degrees to it is let go.
inline constexpr double kPassage_m = 12;

/// Footprints that stand on the ground, by squares of the plane. Keeps a reference to them. O(n log n).
class StandingFootprints {
 public:
  explicit StandingFootprints(std::span<const map::Footprint> footprints);

  /// Numbers of those whose boxes touch, sorted.
  std::vector<std::uint32_t> near(const Box2& box) const;
  const Polygon& operator[](std::uint32_t number) const { return footprints_[number].polygon; }

 private:
  struct Entry {
    std::int32_t column, row;
    std::uint32_t footprint;
    auto operator<=>(const Entry&) const = default;
  };
  std::span<const map::Footprint> footprints_;
  std::vector<Entry> entries_;
  std::vector<Box2> boxes_;
};

/// Everything that stands in the strip of a road, pavements and bends and all. Between two steps an edge that keeps to
/// both, and runs straight, keeps out of the building.
///
/// Total. O(edges of the footprints near each segment).
BuildingObstacles find_building_obstacles(const Road& road, const StripEnds& ends,
                                          const StandingFootprints& footprints);

}  // namespace citykiln::roads
