// Bounding volumes of objects: boxes of the plane between two heights.
#pragma once

#include <vector>

#include "compiler/buildings/recipe.h"
#include "compiler/geometry/box.h"
#include "compiler/geometry/mesh.h"
#include "compiler/geometry/placement.h"
#include "compiler/ground/grading/road_influence.h"
#include "compiler/map/plane/heightfield.h"
#include "compiler/props/recipe.h"
#include "compiler/structures/recipe.h"

namespace citykiln::bake {

/// The margin by which graded ground may be above or below the terrain. Cuts and banks meet the terrain within this
/// distance in plan, so they hardly ever differ from it by more.
inline constexpr double kGraded_m = ground::kGrading_m;

/// A closed box of the plane, and a closed interval of heights.
struct Bounds {
  Box2 plan{};
  double low_m = 0, high_m = 0;
};

/// The distance from a point to the bounds; 0 inside.
double distance_m(const Bounds& bounds, Vec3 place);
/// The distance between the nearest points of both bounds; 0 if they overlap.
double distance_m(const Bounds& a, const Bounds& b);

Bounds bounds_of(const buildings::Building& building);
/// The bounds of a span, parapets and portals included, from the feet of piers to the top of a bore.
Bounds bounds_of(const structures::Span& span);
/// The bounds of a barrier: from the lowest terrain near the axis to the barrier's height above the highest terrain.
Bounds bounds_of(const props::Barrier& barrier, const map::Heightfield& terrain);
/// The bounds of a placed mesh that is 1 m tall and 1 m wide before it is scaled.
Bounds bounds_of(const Placement& placement);
Bounds bounds_of(const Mesh& mesh);

/// The bounds of the terrain in a box.
Bounds bounds_of(const map::Heightfield& terrain, const Box2& box);

}  // namespace citykiln::bake
