// Adds the meshes of a plate, which is a deck that the map has as an area (plates.h).
//
//      |=|________......________|=|     walls on the outline, the surface, and a step down where a road of a bridge
//      |__________________________|     lies on it (...); a slab of constant thickness
#pragma once

#include <vector>

#include "compiler/structures/deck.h"

namespace citykiln::structures {

/// The parts of a plate that a level keeps.
struct PlateDetail {
  bool has_slab = true;      ///< False: only the plate's top is kept.
  bool has_parapets = true;  ///< Must be false if has_slab is false.
};

/// Appends the meshes of a plate to generated.meshes, in plane metres, z up: the top of each part, in the material of
/// the plate's class, and one mesh of concrete with the rest. With a slab, top, sides and underside of each part
/// together are closed. The top of a part below a road is 0.25 m lower, so that the road lies in a step. Each parapet
/// is closed. O(n log n) in corners.
///
/// @param dimensions  Only thickness_m of the slab and parapet_m, the height of parapets above the top, are used.
void add_plate(const Plate& plate, const DeckDimensions& dimensions, PlateDetail detail, GeneratedStructure& generated);

/// Returns the lines of a plate on which walls stand (PlateCorner::has_wall; a wall is a parapet or a railing). Each
/// line is a list of ribs in order along it, at least two, with a mitre at corners; the plate is to the left. A ring
/// whose every edge has a wall is one line that ends where it begins. Empty if no edge has a wall.
std::vector<std::vector<Rib>> wall_runs(const Plate& plate);

}  // namespace citykiln::structures
