// Where the copies of instanced meshes stand, and the doors that they must not bar.
#pragma once

#include <string_view>
#include <vector>

#include "compiler/bake/baked_tile.h"
#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/oriented_rect.h"
#include "compiler/scene/scene.h"

namespace citykiln::verify {

/// Returns the name of the kind of a mesh: "bench" of "bench" and of "bench_2".
std::string_view kind_of_mesh(std::string_view mesh);

/// Returns the plan of a copy of a mesh, less an edge on each side: the mesh's box, turned with the copy; its length
/// lies along the mesh's y axis. A tilt is ignored: that of a car on a slope changes its plan by less than an edge.
OrientedRect plan_of_copy(const bake::InstancedMesh& mesh, std::size_t copy, Vec3 origin, double edge_m);

/// The doors of a tile's buildings.
struct Doors {
  std::vector<Vec2> at;
  BoxGrid grid;
  double about_m = 0;
};

/// Returns the doors, to find those up to about_m from a rectangle. O(n).
Doors doors_of(const scene::Chunk& chunk, double about_m);

/// True if a door is in a rectangle, or nearer to it than Doors::about_m. O(doors near).
bool is_before_door(const OrientedRect& plan, const Doors& doors);

}  // namespace citykiln::verify
