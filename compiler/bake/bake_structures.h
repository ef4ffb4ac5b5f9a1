// Bridges, tunnels and stairs of a tile.
#pragma once

#include <vector>

#include "compiler/bake/baking.h"
#include "compiler/bake/ground_meshes.h"
#include "compiler/structures/generate.h"
#include "compiler/structures/stairs.h"

namespace citykiln::bake {

/// A bridge or a tunnel, expanded.
struct Built {
  structures::GeneratedStructure expanded;
  Bounds bounds;
};

/// Those that are the tile's. A tunnel that is not bored was diagnosed when the map was compiled. Accounts
/// "bake/bridge", "bake/tunnel".
std::vector<Built> generate_structures(const Baking& baking, Report& report);

/// What is painted on bridges and in tunnels goes onto the tile's sheet, after what is painted on the ground.
void bake_structures(Baking& baking, std::vector<Built>& structures, const Markings& markings,
                     std::size_t first_column);

/// Stairs lie on the ground, which is a ramp below them: where the tolerance does not see them, that stays.
void bake_stairs(Baking& baking, const std::vector<structures::Stairs>& all);

}  // namespace citykiln::bake
