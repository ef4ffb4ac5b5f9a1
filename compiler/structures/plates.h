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

/// Returns the bridges with the plates of features.bridge_areas: bridges that a plate carries have no slab of their
/// own, and the first of them stores the plate.
///
/// Guarantees: at a road that it carries, and at nodes where other ways meet its outline, a plate has the height of the
/// bridge there within 2^-7 m; elsewhere the mean of all its bridges, weighted by the inverse square of the distance.
/// Walls stand on the outline except where ways cross it or meet it at a node. O(areas · corners · bridges
/// near).
/// @param bridges  Sorted by id, with profiles.
std::vector<Span> with_plates(std::vector<Span> bridges, const map::FeatureView& features);

/// Returns the height of a plate's top at a place: that of the nearest corner of its parts.
double plate_height_m(const Plate& plate, Vec2 at);

/// True if a place lies on a plate. O(corners).
bool is_on_plate(const Plate& plate, Vec2 at);

/// A plate to be asked for many places.
struct BoxedPlate {
  const Plate* plate = nullptr;
  int layer = 0;  ///< The layer of the bridge that stores it.
  Box2 box;
};

/// Returns all plates of these bridges, which must outlive the result.
std::vector<BoxedPlate> boxed_plates(std::span<const Span> bridges);

/// The like, O(1) outside of the plate's box.
bool is_on_plate(const BoxedPlate& boxed, Vec2 at);

}  // namespace citykiln::structures
