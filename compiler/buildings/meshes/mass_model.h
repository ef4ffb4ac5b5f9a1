// The mass model of a building: the closed volume of walls, roof and foundation that style rules refine. The term is
// from Müller et al., "Procedural Modeling of Buildings", SIGGRAPH 2006.
//
//        /\          roof        above the eaves, by generate_roof()
//       /__\ _ _ _ _ eaves
//       |  |         walls       one face per edge, from the floor or the top of the buried storeys, without what a
//       |__|_ _ _ _  floor       neighbour hides
//       |  |         foundation  down to bottom_m
#pragma once

#include <vector>

#include "compiler/buildings/recipe.h"
#include "compiler/contract/findings/report.h"
#include "grammars/roofs/roof.h"
#include "grammars/shapes/shape.h"

namespace citykiln::buildings {

struct MassModel {
  roofs::Roof roof;  ///< Heights are relative to the eaves.
  /// Walls up to the eaves, in the order of the footprint's edges for every roof form. Tags: kSide, party walls
  /// kInside.
  std::vector<grammars::Face> walls;
  std::vector<grammars::Face> foundation;  ///< Faces below the walls; the underside of lifted buildings.
};

/// Returns the mass model of a building; roof.error_m <= tolerance_m.
///
/// Guarantees: walls, party walls, foundation, roof and floor form a closed surface, vertex to vertex if no storey is
/// buried; buildings on the ground are open at the bottom. With Detail::kPartyWallOpenings, party walls in one plane
/// with the neighbour's are left out. A roof that is replaced by a flat roof gets a diagnosis kRoofFallback. Accepts
/// any building.
MassModel mass_model_of(const Building& building, double tolerance_m, Report& report);

/// Returns the start shape for the rules: walls (kSide, kInside), gables (kVertical), roof planes (kTop), rims and
/// undersides of eaves (kBorder). The scope's x axis follows the longest wall that faces a street, else
/// the longest wall; y points up, and z is x cross y.
grammars::Shape shape_of(const Building& building, const MassModel& mass);

}  // namespace citykiln::buildings
