// Recipes of landforms: mapped objects that shape the land itself, which a heightmap is too coarse to show.
#pragma once

#include "compiler/roads/recipe.h"

namespace citykiln::ground {

/// The forms.
enum class LandformKind : std::uint8_t {
  kStep,      ///< A retaining wall or cliff: the land is higher on one side.
  kRidge,     ///< A dyke or embankment: a crest with slopes of earth.
  kDam,       ///< A crest with steep sides.
  kDeck,      ///< A pier, groyne or breakwater along a line: level, above water.
  kDeckArea,  ///< An area of this kind: the axis is its outer ring.
  kCount
};

/// A landform along an axis. The profile is the height of its top on the axis. The tilt of a step's profile leads from
/// the foot on one side of the wall to the top on the other, over the width of the wall; other kinds have no tilt. The
/// class is that of the surface on top; kUnknown leaves the land cover as it is.
struct Landform : roads::Strip {
  LandformKind kind{};
  bool operator==(const Landform&) const = default;
};

/// The distance from its axis, or from the border of its area, within which a landform changes the land.
inline constexpr double kLandformReach_m = 32;

}  // namespace citykiln::ground
