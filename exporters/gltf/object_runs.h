// Splits a primitive into runs: consecutive vertices and triangles that no triangle connects to the rest. They are the
// objects that were appended one after the other.
#pragma once

#include <cstddef>
#include <vector>

#include "compiler/bake/baked_tile.h"

namespace citykiln::exporters {

/// Vertices and triangles from `first` up to but not including `last`.
struct ObjectRun {
  std::size_t first_vertex = 0, last_vertex = 0, first_triangle = 0, last_triangle = 0;
  std::size_t vertices() const { return last_vertex - first_vertex; }
};

/// Returns the shortest runs such that the triangles of a run use only its vertices. They cover all vertices and
/// triangles, in order. Empty for a primitive without triangles. O(n).
std::vector<ObjectRun> object_runs(const bake::Primitive& primitive);

/// Joins neighbouring runs of one feature. Returns `runs` for a primitive without features. O(runs).
std::vector<ObjectRun> feature_runs(const bake::Primitive& primitive, const std::vector<ObjectRun>& runs);

/// Joins neighbouring runs into as few as possible with at most `most_vertices` each. A longer run stays alone.
std::vector<ObjectRun> joined_runs(const std::vector<ObjectRun>& runs, std::size_t most_vertices);

/// Returns the part of a primitive that is one run; append_primitive() (split_buildings.h) is the inverse.
bake::Primitive part_of(const bake::Primitive& primitive, const ObjectRun& run);

}  // namespace citykiln::exporters
