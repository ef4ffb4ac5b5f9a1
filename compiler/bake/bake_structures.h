// Bridges, tunnels and stairs of a tile.
#pragma once

#include <vector>

#include "compiler/bake/baking.h"
#include "compiler/bake/ground_meshes.h"
#include "compiler/structures/generate.h"
#include "compiler/structures/stairs.h"

namespace citykiln::bake {

/// A bridge or a tunnel, generated but not merged yet.
struct Built {
  structures::GeneratedStructure generated;
  Bounds bounds;
};

/// Generates the bridges and bored tunnels that this tile bakes, clipped to the extent. Other tunnels were diagnosed
/// when the map was compiled. Accounts "bake/bridge", "bake/tunnel".
std::vector<Built> generate_structures(const Baking& baking, Report& report);

/// The marking layouts of structures.
std::vector<roads::MarkingLayout> layouts_of(const std::vector<Built>& structures);

/// Adds bridges and tunnels.
/// @param markings  Of their layouts, and others.
void bake_structures(Baking& baking, std::vector<Built>& structures, const Markings& markings);

/// Adds stairs. They lie on the ground, which is a ramp below them and replaces them where their error is within the
/// tolerance.
void bake_stairs(Baking& baking, const std::vector<structures::Stairs>& all);

}  // namespace citykiln::bake
