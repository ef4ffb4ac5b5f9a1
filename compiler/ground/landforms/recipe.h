// Recipes of landforms: mapped objects that shape the land, such as cliffs and dykes. A heightmap is too coarse to show
// them.
#pragma once

#include "compiler/roads/recipe.h"

namespace citykiln::ground {

/// The kinds of landforms.
enum class LandformKind : std::uint8_t {
  kStep,      ///< A retaining wall or cliff: the land is higher on one side.
  kRidge,     ///< A dyke or embankment: a crest with slopes of earth.
  kDam,       ///< A crest with steep sides.
  kDeck,      ///< A pier, groyne or breakwater along a line: level, above water.
  kDeckArea,  ///< A deck that is mapped as an area: the axis is its outer ring, the first point not repeated.
  kLevel,     ///< An area that is one plane, such as a pitch; its axis is a ring too.
  kCount
};

/// A landform along an axis. The profile holds the height of its top; for a step, the height halfway between foot and
/// top. A step's tilt leads from the foot on one side of the wall to the top on the other, over the width of the wall;
/// other kinds have no tilt, but kLevel: the tilts of its first and second knot are the plane's slopes east and north,
/// and their height is that of the ring's first point. `surface` is the land cover on top; kUnknown leaves the land
/// cover as it is.
struct Landform : roads::Strip {
  LandformKind kind{};
  bool operator==(const Landform&) const = default;
};

/// True for kinds whose axis is the outer ring of an area.
constexpr bool is_area(LandformKind kind) { return kind == LandformKind::kDeckArea || kind == LandformKind::kLevel; }

/// The distance within which a landform changes the land: from the axis of a step, from the edges of other kinds.
inline constexpr double kLandformReach_m = 32;

}  // namespace citykiln::ground
