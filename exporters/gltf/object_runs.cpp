#include "exporters/gltf/object_runs.h"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace citykiln::exporters {
namespace {

using bake::Primitive;

template <typename T>
std::vector<T> slice(const std::vector<T>& values, std::size_t first, std::size_t last) {
  if (values.empty()) return {};
  return {values.begin() + static_cast<std::ptrdiff_t>(first), values.begin() + static_cast<std::ptrdiff_t>(last)};
}

// The smallest vertex of each triangle and all that follow.
std::vector<std::uint32_t> smallest_from(const Primitive& primitive) {
  std::vector<std::uint32_t> smallest(primitive.triangles.size());
  std::uint32_t least = std::numeric_limits<std::uint32_t>::max();
  for (std::size_t t = smallest.size(); t-- > 0;)
    smallest[t] = least = std::min(least, *std::ranges::min_element(primitive.triangles[t]));
  return smallest;
}

}  // namespace

std::vector<ObjectRun> object_runs(const Primitive& primitive) {
  std::vector<ObjectRun> runs;
  const std::vector<std::uint32_t> smallest = smallest_from(primitive);
  ObjectRun run;
  std::uint32_t largest = 0;
  for (std::size_t t = 0; t < smallest.size(); ++t) {
    if (t > 0 && largest < smallest[t]) {
      run.last_vertex = smallest[t], run.last_triangle = t;
      runs.push_back(run);
      run = {run.last_vertex, 0, t, 0};
    }
    largest = std::max(largest, *std::ranges::max_element(primitive.triangles[t]));
  }
  run.last_vertex = primitive.positions.size(), run.last_triangle = smallest.size();
  if (run.last_triangle > 0) runs.push_back(run);
  return runs;
}

std::vector<ObjectRun> feature_runs(const Primitive& primitive, const std::vector<ObjectRun>& runs) {
  if (primitive.features.empty()) return runs;
  std::vector<ObjectRun> joined;
  for (const ObjectRun& run : runs) {
    if (joined.empty() || primitive.features[joined.back().first_vertex] != primitive.features[run.first_vertex])
      joined.push_back(run);
    else
      joined.back().last_vertex = run.last_vertex, joined.back().last_triangle = run.last_triangle;
  }
  return joined;
}

std::vector<ObjectRun> joined_runs(const std::vector<ObjectRun>& runs, std::size_t most_vertices) {
  std::vector<ObjectRun> joined;
  for (const ObjectRun& run : runs) {
    if (joined.empty() || run.last_vertex - joined.back().first_vertex > most_vertices) {
      joined.push_back(run);
      continue;
    }
    joined.back().last_vertex = run.last_vertex, joined.back().last_triangle = run.last_triangle;
  }
  return joined;
}

Primitive part_of(const Primitive& primitive, const ObjectRun& run) {
  Primitive part;
  part.material = primitive.material, part.colour_source = primitive.colour_source;
  part.layer = primitive.layer;
  part.positions = slice(primitive.positions, run.first_vertex, run.last_vertex);
  part.normals = slice(primitive.normals, run.first_vertex, run.last_vertex);
  part.colours = slice(primitive.colours, run.first_vertex, run.last_vertex);
  part.features = slice(primitive.features, run.first_vertex, run.last_vertex);
  part.uvs = slice(primitive.uvs, run.first_vertex, run.last_vertex);
  part.triangles = slice(primitive.triangles, run.first_triangle, run.last_triangle);
  for (auto& triangle : part.triangles)
    for (std::uint32_t& vertex : triangle) vertex -= static_cast<std::uint32_t>(run.first_vertex);
  return part;
}

}  // namespace citykiln::exporters
