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

/// The roof below a thing. Both are heights in plane metres.
struct RoofBelow {
  /// The lowest floor of the buildings there that stand on the ground, else that of the building.
  double ground_m = 0;
  double roof_m = 0;  ///< The lowest place of the roof below the thing's base.
};

/// The roofs of buildings, by place. Refers to the buildings, which must outlive it unchanged.
class Roofs {
 public:
  explicit Roofs(std::span<const buildings::Building> buildings);

  /// Returns the highest roof at a place; nothing outside of buildings. The roof's height is that of its mass model at
  /// a tolerance of 5 cm, at the lowest of five places: `at`, and those at radius_m from it along both axes that lie on
  /// the same building. Cost: generating the mass models of the buildings there.
  /// @param at        Plane metres.
  /// @param radius_m  Half the width of the thing's base.
  std::optional<RoofBelow> below(Vec2 at, double radius_m) const;

 private:
  std::span<const buildings::Building> buildings_;
  BoxGrid grid_;
};

/// The lower end of a thing on a building, and its size from there.
struct FootOnRoof {
  std::optional<double> foot_m;  ///< Plane metres, snapped; nothing: it stands on the ground.
  double height_m = 0;           ///< From the foot to the top. Snapped, except where foot_m is nothing.
};

/// Returns the foot and the height of a thing on a building. The first case that applies counts:
/// 1. min_height is tagged: the foot is min_height above the ground, but not above the roof. The top is at the tagged
///    height if that is above min_height; else the thing has its own height.
/// 2. It is higher than the building and not tagged to be on its roof, and its kind is kThroughRoof: it stands on the
///    ground with ThingFeature::height_m, which is not snapped.
/// 3. It is so, but of another kind, and its height is tagged: the foot is on the roof. The height is the part of the
///    tagged one above the roof, but at least 2 m, or all of it if that is less.
/// 4. Else: the foot is on the roof, and the thing has its own height.
///
/// Its own height is the tagged one, else that of its kind, but at most the larger of 3 m and half of the building's
/// height above the ground. O(1).
FootOnRoof foot_on_roof(const map::ThingFeature& thing, map::Stand stand, const RoofBelow& below);

}  // namespace citykiln::things
