// Bakes the bridges, tunnels and stairs of a tile.
#pragma once

#include <vector>

#include "compiler/bake/baking.h"
#include "compiler/bake/ground/ground_meshes.h"
#include "compiler/structures/generate.h"
#include "compiler/structures/stairs.h"

namespace citykiln::bake {

/// A bridge or a tunnel, generated but not merged yet.
struct Built {
  structures::GeneratedStructure generated;
  Bounds bounds;
};

/// Generates the bridges and bored tunnels that belong to this tile, clipped to the extent. Tunnels that are not bored
/// were diagnosed when the map was compiled. Accounts "bake/bridge", "bake/tunnel".
std::vector<Built> generate_structures(const Baking& baking, Report& report);

/// The marking layouts of structures.
std::vector<roads::MarkingLayout> layouts_of(const std::vector<Built>& structures);

/// Adds bridges and tunnels.
/// @param markings  Markings that include all of their layouts.
void bake_structures(Baking& baking, std::vector<Built>& structures, const Markings& markings);

/// Adds stairs. Stairs whose error is within the tolerance are left out: the ground below them is a ramp.
void bake_stairs(Baking& baking, const std::vector<structures::Stairs>& all);

}  // namespace citykiln::bake
