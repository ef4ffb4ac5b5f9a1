// The height of the ground at a place, for viewpoints that are given in metres above the ground.
#pragma once

#include <optional>
#include <span>

#include "compiler/bake/baked_tile.h"
#include "compiler/geometry/vec.h"
#include "compiler/scene/scene.h"

namespace citykiln::commands {

/// Returns the height of the highest triangle of the layers ground, roads and water at a place, in plane metres; empty
/// if there is none. O(triangles of these layers).
std::optional<double> ground_height_m(std::span<const bake::BakedTile> tiles, Vec2 place);

/// Returns the height of the graded terrain (the terrain after roads and water have cut into it) at a place, in plane
/// metres; empty outside all tiles. Cost: grading the terrain of one tile.
std::optional<double> ground_height_m(const scene::Scene& scene, Vec2 place);

}  // namespace citykiln::commands
