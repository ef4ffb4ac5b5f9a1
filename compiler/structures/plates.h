// Plates: decks that the map has as areas. The bridges on a plate give its heights.
//
//     +-----------------+     the outline; ═ a bridge that the plate carries: its road lies on the plate,
//     |═════════════════|     and the rest has the heights of the nearest roads
//     +-----------------+
#pragma once

#include <span>
#include <vector>

#include "compiler/geometry/box.h"
#include "compiler/map/features.h"
#include "compiler/structures/recipe.h"

namespace citykiln::structures {

/// Returns the bridges with the plates of features.bridge_areas. The plate of an area is stored with the first of the
/// bridges in BridgeArea::tracks; an area of whose bridges none is given has no plate. Span::deck of these bridges is
/// kNone for the area's own axes, kPlate for bridges of which kCarriedShare lies on the area, and kOwn for others.
///
/// Heights: a corner of a plate has the weighted mean of the heights of all its bridges, each taken at the nearest
/// place of its axis, rounded to kProfileQuantum_m. The weight is the inverse square of the distance from the bridge's
/// road, or from the line of an area's own axis, plus (1 cm)². At a road it is the road's height, but for the weight of
/// other roads within centimetres of it, such as where two bridges meet.
///
/// Walls stand on the outline, with gaps: where a bridge that the plate carries crosses the outline or ends within 3 m
/// of it, and at nodes of the outline that other ways have, tunnels excepted. A gap is as wide as the way, and 0.25 m
/// more on either side. Other ways that cross the outline without a node leave no gap.
///
/// O(n log n) in tracks, plus O(corners · segments of the bridges and gaps) for each area.
/// @param bridges  Sorted by id, with profiles.
std::vector<Span> with_plates(std::vector<Span> bridges, const map::FeatureView& features);

/// Returns the height of a plate's top at a place, plane metres: that of the nearest corner of its parts; 0 without
/// corners. O(corners).
double plate_height_m(const Plate& plate, Vec2 at);

/// True if a place lies on a part of a plate, in plan. O(corners).
bool is_on_plate(const Plate& plate, Vec2 at);

/// A plate with its box, for tests of many places.
struct BoxedPlate {
  const Plate* plate = nullptr;
  int layer = 0;  ///< The layer of the bridge that stores it.
  Box2 box;       ///< Plane metres.
};

/// Returns all plates of these bridges, in their order. The result refers to the plates: the bridges must outlive it
/// unchanged.
std::vector<BoxedPlate> boxed_plates(std::span<const Span> bridges);

/// True if a place lies on the plate, in plan. O(corners) inside of the plate's box, else O(1).
bool is_on_plate(const BoxedPlate& boxed, Vec2 at);

}  // namespace citykiln::structures
