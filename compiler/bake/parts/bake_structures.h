// Bakes the bridges, tunnels and stairs of a tile.
#pragma once

#include <vector>

#include "compiler/bake/baking.h"
#include "compiler/bake/ground/ground_meshes.h"
#include "compiler/structures/generate.h"
#include "compiler/structures/stairs.h"

namespace citykiln::bake {

/// A bridge or tunnel with its generated meshes, before they are merged with others.
struct GeneratedSpan {
  structures::GeneratedStructure generated;
  Bounds bounds;
};

/// Generates the bridges and bored tunnels that belong to this tile, clipped to the extent. Other tunnels have no mesh;
/// they were diagnosed when the map was compiled. Accounts "bake/bridge", "bake/tunnel".
std::vector<GeneratedSpan> generate_structures(const Baking& baking, Report& report);

/// Returns the marking layouts (patterns of painted lines) of all strips of road on structures.
std::vector<roads::MarkingLayout> layouts_of(const std::vector<GeneratedSpan>& structures);

/// Adds the meshes of bridges and tunnels, and their errors, to the tile.
/// @param markings  A marking atlas that contains all layouts of the structures.
void bake_structures(Baking& baking, std::vector<GeneratedSpan>& structures, const Markings& markings);

/// Adds stairs. Stairs whose error is within the tolerance are left out: the ground below them is a ramp.
/// Handrails are left out from kHandrailError_m on.
/// @param all  The stairs of the whole tile.
void bake_stairs(Baking& baking, const std::vector<structures::Stairs>& all);

}  // namespace citykiln::bake
