// Reference triangulations of random borders and heights, and of a grid.
#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "compiler/contract/random_sequence.h"
#include "compiler/geometry/arrangement.h"
#include "compiler/ground/mesh/reference.h"
#include "compiler/map/plane/heightfield.h"

namespace citykiln::ground {

inline Delaunay triangulated(const Arrangement& arrangement) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const ArrangedEdge& e : arrangement.edges) edges.emplace_back(e.a, e.b);
  return Delaunay(arrangement.vertices, edges);
}

/// A reference of crossing segments, some of them along lines of a grid, and of points on the cell's border, with
/// random heights.
inline Reference random_reference(const Box2& cell, std::uint64_t seed, int segments, double height_m) {
  const RandomSequence draw(seed, StableId{7}, "segments");
  std::vector<OwnedSegment> borders;
  for (int s = 0; s < segments; ++s) {
    const auto place = [&](std::uint32_t i) {
      const auto index = static_cast<std::uint32_t>(s) * 4 + i;
      const double x = draw.between(cell.min.x - 20, cell.max.x + 20, index);
      const double y = draw.between(cell.min.y - 20, cell.max.y + 20, index + 2);
      return s % 3 == 0 ? grid_point({std::floor(x / 8) * 8, std::floor(y / 8) * 8}) : grid_point({x, y});
    };
    borders.push_back({place(0), place(1), 0, 1});
  }
  const Arrangement arrangement = arrange(borders, {}, cell);
  std::vector<Heights> heights;
  const RandomSequence metres(seed, StableId{8}, "heights");
  for (std::uint32_t i = 0; i < arrangement.vertices.size() * 4; i += 4)
    heights.push_back({height_m * metres.unit(i), height_m * metres.unit(i + 1), height_m * metres.unit(i + 2),
                       height_m * metres.unit(i + 3)});
  return reference_of(triangulated(arrangement), std::move(heights), cell);
}

/// A reference of the field's own triangles over its box; all layers are equal.
inline Reference reference_of_field(const map::Heightfield& field) {
  std::vector<GridPoint> vertices;
  std::vector<Heights> heights;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (int j = 0; j < field.rows; ++j)
    for (int i = 0; i < field.columns; ++i) {
      const auto v = static_cast<std::uint32_t>(vertices.size()), row = static_cast<std::uint32_t>(field.columns);
      vertices.push_back(grid_point(field.vertex(i, j)));
      heights.emplace_back();
      heights.back().fill(field.height_m_at_vertex(i, j));
      if (i + 1 < field.columns) edges.emplace_back(v, v + 1);
      if (j + 1 < field.rows) edges.emplace_back(v, v + row);
      if (i + 1 < field.columns && j + 1 < field.rows) edges.emplace_back(v, v + row + 1);
    }
  return reference_of(Delaunay(vertices, edges), std::move(heights), field.box());
}

}  // namespace citykiln::ground
