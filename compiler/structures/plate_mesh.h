// Adds the meshes of a plate: a deck that the map has as an area (plates.h).
//
//      |=|________......________|=|     walls on the outline, the surface, and a step down where a road of a bridge
//      |__________________________|     lies on it (...); a slab of constant thickness
#pragma once

#include <vector>

#include "compiler/structures/deck.h"

namespace citykiln::structures {

/// The parts of a plate that a level keeps.
struct PlateDetail {
  bool has_slab = true;      ///< Else only its top.
  bool has_parapets = true;  ///< Only with a slab.
};

/// Adds the parts of a plate as closed prisms, or their tops alone, and closed parapets or upstands along its walls.
/// @param dimensions  Thickness and height of the parapets.
void add_plate(const Plate& plate, const DeckDimensions& dimensions, PlateDetail detail, GeneratedStructure& generated);

/// Returns ribs along each run of walls; to the left is the plate. Each run has at least two ribs.
std::vector<std::vector<Rib>> wall_runs(const Plate& plate);

}  // namespace citykiln::structures
