// The volume of a building: walls, roof and foundations, before any rule has worked on them.
//
//        /\          roof     over the eaves, by generate_roof()
//       /__\ _ _ _ _ eaves
//       |  |         walls    one face an edge, from the floor or from over the buried storeys, without what a
//       |__|_ _ _ _  floor    neighbour hides
//       |  |         foundations, down to the bottom
#pragma once

#include <vector>

#include "compiler/buildings/recipe.h"
#include "compiler/contract/report.h"
#include "grammars/roofs/roof.h"
#include "grammars/shapes/shape.h"

namespace citykiln::buildings {

struct MassModel {
  roofs::Roof roof;  ///< Heights over the eaves.
  /// Up to the eaves, in the order of the footprint's edges, whatever the roof. kSide; kInside where a neighbour stands
  /// before it.
  std::vector<grammars::Face> walls;
  std::vector<grammars::Face> foundation;  ///< Below the walls; the underside of what hangs in the air.
};

/// Guarantees: walls without party walls, foundation, roof and floor close, corner to corner where no storey is buried,
/// and with them what stands is open at the bottom alone. Roofs that fall back to flat are diagnosed kRoofFallback.
/// roof.error_m <= tolerance_m. Total.
MassModel mass_model_of(const Building& building, double tolerance_m, Report& report);

/// What rules start with: walls (kSide, kInside), gables (kVertical), roof planes (kTop), rims and undersides of eaves
/// (kBorder). The scope's x runs along the longest wall at a street, z up.
grammars::Shape shape_of(const Building& building, const MassModel& mass);

}  // namespace citykiln::buildings
