// Bridges, tunnels and stairs of a tile.
#pragma once

#include <vector>

#include "compiler/bake/dress_ground.h"
#include "compiler/bake/firing.h"
#include "compiler/structures/expand.h"
#include "compiler/structures/stairs.h"

namespace citykiln::bake {

/// A bridge or a tunnel, expanded.
struct Built {
  structures::Expanded expanded;
  Bounds bounds;
};

/// Those that are the tile's. A tunnel that is not bored was diagnosed when the map was compiled. Accounts
/// "bake/bridge", "bake/tunnel".
std::vector<Built> expand_structures(const Firing& firing, Report& report);

/// What is painted on bridges and in tunnels goes onto the tile's sheet, after what is painted on the ground.
void fire_structures(Firing& firing, std::vector<Built>& structures, const Markings& markings,
                     std::size_t first_column);

/// Stairs lie on the ground, which is a ramp below them: where the tolerance does not see them, that stays.
void fire_stairs(Firing& firing, const std::vector<structures::Stairs>& all);

}  // namespace citykiln::bake
