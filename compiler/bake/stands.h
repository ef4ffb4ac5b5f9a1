// Stands: the many plants of one map element as one mesh, for programs that become slow with a node for each plant.
#pragma once

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "compiler/bake/baked_tile.h"
#include "compiler/bake/prototype_cache.h"
#include "compiler/plants/generate.h"

namespace citykiln::bake {

/// In a tile with too many plants, elements (woods, hedges, rows, fields) with more plants than this may become stands.
/// Mapped trees, which are elements of their own, never do.
inline constexpr std::size_t kFewestStandPlants = 16;
/// The smallest tolerance of plants in stands, as a share of their species' height: crowns are a few cards.
inline constexpr double kStandTolerance = 1.0 / 16;

/// The plants of each stand, by element and species.
using Stands = std::map<std::pair<OsmId, plants::Prototype>, std::vector<Placement>>;

/// The tolerance of the plants of a stand, in a tile with a tolerance.
double stand_tolerance_m(plants::Species species, double tolerance_m);

/// Moves the plants of stands out of `placed`, the largest stands first, until at most `most` plants or no stands are
/// left in it. Variants that look alike at the tolerance of the stand are merged.
Stands take_stands(plants::PlacedPlants& placed, double tolerance_m, std::size_t most);

/// Returns a stand as an instanced mesh with one instance, at its first plant. It has no primitives if the plants are
/// below the tolerance. O(plants · triangles of a prototype).
/// @param height_m  Height of the prototype.
/// @param origin    Origin of the tile.
/// @param feature   Index into BakedTile::features.
InstancedMesh stand_mesh(const BakedPrototype& prototype, double height_m, const std::vector<Placement>& plants,
                         Vec3 origin, std::uint32_t feature);

}  // namespace citykiln::bake
