// Bounds of objects: a box in plan and an interval of heights, in plane metres.
#pragma once

#include <string_view>
#include <vector>

#include "compiler/buildings/recipe.h"
#include "compiler/geometry/box.h"
#include "compiler/geometry/mesh.h"
#include "compiler/geometry/placement.h"
#include "compiler/ground/grading/road_influence.h"
#include "compiler/map/plane/heightfield.h"
#include "compiler/props/recipe.h"
#include "compiler/scene/kinds.h"
#include "compiler/structures/recipe.h"
#include "compiler/structures/stairs.h"
#include "compiler/wires/recipe.h"

namespace citykiln::bake {

/// The difference in height between the terrain and the ground after roads and water have cut into it that bounds allow
/// for. An estimate, not a bound: cuts and banks meet the terrain within this distance in plan, so that only slopes of
/// more than 45° exceed it.
inline constexpr double kGraded_m = ground::kGrading_m;

/// A closed box of the plane, and a closed interval of heights.
struct Bounds {
  Box2 plan{};
  double low_m = 0, high_m = 0;
};

/// The distance in space from a point to the bounds; 0 inside.
double distance_m(const Bounds& bounds, Vec3 place);
/// The distance between the nearest points of both bounds; 0 if they overlap.
double distance_m(const Bounds& a, const Bounds& b);

/// The bounds of a building from its recipe.
Bounds bounds_of(const buildings::Building& building);
Bounds bounds_of(const structures::Stairs& stairs);
/// The bounds of a bridge or tunnel, parapets and portals included: from the feet of the piers to the ceiling of a
/// tunnel.
Bounds bounds_of(const structures::Span& span);
/// The bounds of a barrier (wall, fence, hedge): from the lowest terrain near its axis to its height above the highest
/// terrain there.
Bounds bounds_of(const props::Barrier& barrier, const map::Heightfield& terrain);
/// The bounds of the wires of a span.
Bounds bounds_of(const wires::WireSpan& span);
/// The bounds of a placed plant or lamp, a mesh that is 1 m tall before Placement::scale enlarges it:
/// plants::kCrownReach heights around its foot in plan, and from its foot to its top.
Bounds bounds_of(const Placement& placement);
/// The bounds of a mesh's vertices.
Bounds bounds_of(const Mesh& mesh);

/// The types of recipes that have an overload of bounds_of(): each object has a mesh of its own.
template <typename Object>
concept Bounded = requires(const Object& object) {
  bounds_of(object);
}
|| requires(const Object& object, const map::Heightfield& terrain) { bounds_of(object, terrain); };
/// Returns the bounds of an object of a chunk.
template <Bounded Object>
Bounds bounds_in(const scene::Chunk& chunk, const Object& object) {
  if constexpr (requires { bounds_of(object); })
    return bounds_of(object);
  else
    return bounds_of(object, chunk.heights);
}
/// Calls visit(object, bounds) for each object that has bounds: buildings, bridges, tunnels, barriers, wires.
template <typename Visit>
void for_each_bounded(const scene::Chunk& chunk, Visit visit) {
  scene::for_each_element_kind(chunk, [&]<typename Object>(std::string_view, const std::vector<Object>& objects) {
    if constexpr (Bounded<Object>)
      for (const Object& object : objects) visit(object, bounds_in(chunk, object));
  });
}

/// The bounds of the terrain in a box.
Bounds bounds_of(const map::Heightfield& terrain, const Box2& box);

}  // namespace citykiln::bake
