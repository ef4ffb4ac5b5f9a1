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

/// Where a tile has too many plants, an element (a wood, a hedge, a row, a field) with more plants than this may become
/// a stand. Mapped trees, which are elements of their own, never do.
inline constexpr std::size_t kFewestStandPlants = 16;
/// Plants of stands have at least this tolerance, as a share of their species' height: crowns of a few cards.
inline constexpr double kStandTolerance = 1.0 / 16;

/// The plants of each stand, by element and species.
using Stands = std::map<std::pair<OsmId, plants::Prototype>, std::vector<Placement>>;

/// The tolerance of the plants of a stand in a tile of this tolerance.
double stand_tolerance_m(plants::Species species, double tolerance_m);

/// Takes the plants of stands out of `placed`, the largest stands first, until it holds at most `most` plants or no
/// stand. Variants that look alike at the tolerance of the stand are merged.
Stands take_stands(plants::PlacedPlants& placed, double tolerance_m, std::size_t most);

/// Returns a stand as an instanced mesh with one instance, at its first plant. No primitives where the tolerance drops
/// the plants. O(plants · triangles of a prototype).
/// @param height_m  Of the prototype.
/// @param origin   The tile's.
/// @param feature  Index into BakedTile::features.
InstancedMesh stand_mesh(const BakedPrototype& prototype, double height_m, const std::vector<Placement>& plants,
                         Vec3 origin, std::uint32_t feature);

}  // namespace citykiln::bake
