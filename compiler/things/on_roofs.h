// The roofs of a map, and the feet of the things that stand on them.
//
//        |   tagged height, if it is more than that of the roof, counts from the ground;
//      __|__ a lower one is the thing's own
//     |     |
//     |     |  min_height is the height of the foot above the ground, at most that of the roof
//     ¯¯¯¯¯¯¯
#pragma once

#include <optional>
#include <span>

#include "compiler/buildings/recipe.h"
#include "compiler/geometry/box_grid.h"
#include "compiler/map/features.h"
#include "compiler/map/things/thing_table.h"

namespace citykiln::things {

/// The roof below a thing, plane metres.
struct RoofBelow {
  double ground_m = 0;  ///< The height from which the heights of the building are measured.
  double roof_m = 0;    ///< The lowest place of the roof below the thing's base.
};

/// The roofs of buildings.
class Roofs {
 public:
  /// @param buildings  Must outlive the object.
  explicit Roofs(std::span<const buildings::Building> buildings);

  /// Returns the highest roof at a place; nothing outside of buildings. Its height is that of the finest level.
  /// O(roof).
  /// @param radius_m  Half the width of the thing's base.
  std::optional<RoofBelow> below(Vec2 at, double radius_m) const;

 private:
  std::span<const buildings::Building> buildings_;
  BoxGrid grid_;
};

/// The lower end of a thing on a building, and its size from there.
struct FootOnRoof {
  std::optional<double> foot_m;  ///< Plane metres, snapped; nothing: it stands on the ground.
  double height_m = 0;           ///< Snapped, > 0.
};

/// Returns where a thing on a building has its foot. A height that is not tagged is at most half of the building's.
FootOnRoof foot_on_roof(const map::ThingFeature& thing, map::Stand stand, const RoofBelow& below);

}  // namespace citykiln::things
