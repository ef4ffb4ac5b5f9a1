// From a footprint and two heights to walls and a roof.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/buildings/recipe.h"
#include "compiler/materials/dressed_mesh.h"

namespace citykiln::buildings {

struct Expanded {
  std::vector<materials::DressedMesh> meshes;  ///< Walls, then roof; an underside where the building hangs in the air.
  double error_m = 0;
};

/// A prism. Walls are flat, outward; the roof is triangulated with its holes. A building lower than the tolerance is
/// dropped, with its height as error. Tints are drawn from (seed, id). O(n log n).
Expanded expand(const Building& building, std::uint64_t seed, double tolerance_m);

}  // namespace citykiln::buildings
