// The height of the ground at a place, for viewpoints given in metres above it.
#pragma once

#include <optional>
#include <span>

#include "compiler/bake/baked_tile.h"
#include "compiler/geometry/vec.h"
#include "compiler/scene/scene.h"

namespace citykiln::commands {

/// The highest triangle of the layers ground, roads and water above or below a place, plane metres; empty where there
/// is none. O(triangles of these layers).
std::optional<double> ground_height_m(std::span<const bake::BakedTile> tiles, Vec2 place);

/// The height of the graded terrain at a place, plane metres; empty outside of all tiles. Cost: that of grading the
/// terrain of one tile.
std::optional<double> ground_height_m(const scene::Scene& scene, Vec2 place);

}  // namespace citykiln::commands
