// Where things are: boxes of the plane between two heights.
#pragma once

#include <vector>

#include "compiler/buildings/recipe.h"
#include "compiler/geometry/box.h"
#include "compiler/geometry/mesh.h"
#include "compiler/geometry/placement.h"
#include "compiler/map/heightfield.h"
#include "compiler/props/recipe.h"
#include "compiler/structures/recipe.h"

namespace citykiln::bake {

/// Heights of the plane; plan and heights closed.
struct Bounds {
  Box2 plan{};
  double low_m = 0, high_m = 0;
};

/// 0 for a place within.
double distance_m(const Bounds& bounds, Vec3 place);

Bounds bounds_of(const buildings::Building& building);
/// As wide as whatever stands on its edges or about its mouths, as low as its piers' feet, as high as a bore.
Bounds bounds_of(const structures::Span& span);
/// On the terrain near its axis, and its own height above that.
Bounds bounds_of(const props::Barrier& barrier, const map::Heightfield& terrain);
/// A mesh 1 m tall, and as wide, placed.
Bounds bounds_of(const Placement& placement);
Bounds bounds_of(const Mesh& mesh);

/// The terrain in a box and a little around it.
Bounds bounds_of(const map::Heightfield& terrain, const Box2& box);

}  // namespace citykiln::bake
