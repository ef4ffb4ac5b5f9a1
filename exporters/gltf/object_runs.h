// The runs of a primitive's vertices that no triangle connects: objects that were merged one after the other.
#pragma once

#include <cstddef>
#include <vector>

#include "compiler/bake/baked_tile.h"

namespace citykiln::exporters {

/// Vertices and triangles, from the first to before the last.
struct ObjectRun {
  std::size_t first_vertex = 0, last_vertex = 0, first_triangle = 0, last_triangle = 0;
  std::size_t vertices() const { return last_vertex - first_vertex; }
};

/// Returns the shortest runs: the triangles of a run use its vertices only. They cover all vertices and triangles, in
/// order. None for a primitive without triangles. O(n).
std::vector<ObjectRun> object_runs(const bake::Primitive& primitive);

/// Returns runs joined to as few as possible with at most `most_vertices` each; a run with more stays alone.
std::vector<ObjectRun> joined_runs(const std::vector<ObjectRun>& runs, std::size_t most_vertices);

/// Returns the part of a primitive that is one run; append_primitive() (split_buildings.h) is the inverse.
bake::Primitive part_of(const bake::Primitive& primitive, const ObjectRun& run);

}  // namespace citykiln::exporters
