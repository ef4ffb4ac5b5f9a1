// Stands: the plants of one map element (such as a wood) that have one species, merged into one mesh. They are made for
// programs that become slow with a scene node for each plant.
//
// A prototype is one of the few distinct plants of a species, made once and placed many times; its number within the
// species is its variant. At coarse tolerances several variants share one mesh.
#pragma once

#include <compare>
#include <cstddef>
#include <map>
#include <span>
#include <vector>

#include "compiler/bake/baked_tile.h"
#include "compiler/bake/prototype_cache.h"
#include "compiler/geometry/box.h"
#include "compiler/plants/generate.h"
#include "compiler/roads/recipe.h"

namespace citykiln::bake {

/// Elements with up to this many plants do not become stands. Mapped single trees are elements of one plant and never
/// do.
inline constexpr std::size_t kMostLoosePlants = 16;
/// The smallest tolerance of plants in stands, as a share of the tallest height of their species: at the edge of woods,
/// where they are seen from the ground, and inside, where they are seen from above. A crown then consists of some 170
/// or 40 leaf cards (textured rectangles).
inline constexpr double kEdgeTolerance = 1.0 / 16, kInnerTolerance = 1.0 / 8;
/// A plant is inside of a wood if all squares of this size, in metres, about its own have plants of stands and no road.
inline constexpr double kWoodSquare_m = 16;

/// The tile, beyond whose box woods are taken to go on, and its roads: people see woods from them.
struct StandSurroundings {
  Box2 tile;
  std::span<const roads::Road> roads;
};

/// The plants of one stand have these in common. An element with several species or variants has several stands.
struct StandKey {
  OsmId element;
  plants::Prototype prototype;  ///< The mesh that they use.
  bool is_inner = false;        ///< True inside of a wood.
  auto operator<=>(const StandKey&) const = default;
};

/// The stands of a tile.
using Stands = std::map<StandKey, std::vector<Placement>>;

/// Returns the tolerance for the plants of a stand: the tile's tolerance, at least kEdgeTolerance or kInnerTolerance of
/// the species' tallest height.
/// @param tolerance_m  The tile's tolerance.
double stand_tolerance_m(const plants::SpeciesValues& species, double tolerance_m, bool is_inner);

/// Moves plants out of `placed` into stands, all plants of one element at a time, the elements with the most plants
/// first. Stops when at most `most` plants are left in `placed`, or no element with more than kMostLoosePlants. Trees
/// of roads (tree-lined ones, street trees) stay.
/// @param placed       The plants of a tile by prototype.
/// @param tolerance_m  The tile's tolerance. Variants that share a mesh at stand_tolerance_m() are in one stand.
Stands take_stands(plants::PlacedPlants& placed, const StandSurroundings& around, double tolerance_m, std::size_t most,
                   const plants::SpeciesTable& table = plants::shipped_table());

/// Returns a stand as a mesh with a single instance, whose origin is the stand's first plant. The mesh has no
/// primitives if the plants are smaller than the tolerance. O(plants · triangles of a prototype).
/// @param prototype  The mesh that all plants of the stand share.
/// @param height_m   Height of that mesh.
/// @param plants     The plants of the stand; not empty. Placement::scale is a plant's height in metres.
/// @param origin     Origin of the tile, plane metres.
/// @param feature    Index of the map element in BakedTile::features.
InstancedMesh stand_mesh(const BakedPrototype& prototype, double height_m, const std::vector<Placement>& plants,
                         Vec3 origin, std::uint32_t feature);

}  // namespace citykiln::bake
