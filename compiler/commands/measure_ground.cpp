#include "compiler/commands/measure_ground.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "compiler/map/surface_class.h"

namespace citykiln::commands {
namespace {

using Corners = std::array<Vec3, 3>;

bool is_of_ground(materials::Material material) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(map::SurfaceClass::kCount); ++i) {
    if (map::values_of(static_cast<map::SurfaceClass>(i)).material == material) return true;
  }
  return false;
}

/// Calls visit(corners) for every triangle of a ground material whose feature stays on the ground, in plane metres.
template <typename Visit>
void for_each_ground_triangle(const bake::BakedTile& tile, std::span<const OsmId> leaving, Visit visit) {
  for (const bake::Primitive& primitive : tile.primitives) {
    if (!is_of_ground(primitive.material)) continue;
    for (const auto& triangle : primitive.triangles) {
      if (std::ranges::binary_search(leaving, tile.features[primitive.features[triangle[0]]])) continue;
      Corners corners;
      for (std::size_t i = 0; i < 3; ++i) {
        const bake::Float3& p = primitive.positions[triangle[i]];
        corners[i] = Vec3{p[0], p[1], p[2]} + tile.origin;
      }
      visit(corners);
    }
  }
}

double twice_area_m2(Vec2 a, Vec2 b, Vec2 c) { return cross(b - a, c - a); }

/// The squares of a lattice, each with the lowest ground at its middle.
struct Lattice {
  Box2 box;
  double step_m;
  int columns, rows;
  std::vector<double> lowest_m;

  Vec2 middle(int i, int j) const { return {box.min.x + (i + 0.5) * step_m, box.min.y + (j + 0.5) * step_m}; }
};

Lattice lattice_of(const Box2& box, double step_m) {
  const int columns = static_cast<int>(box.width() / step_m), rows = static_cast<int>(box.height() / step_m);
  const std::size_t count = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  return {box, step_m, columns, rows, std::vector<double>(count, std::numeric_limits<double>::infinity())};
}

/// Lowers the lattice where the middle of a square lies in the triangle.
void lower(Lattice& lattice, const Corners& t) {
  const double area = twice_area_m2(in_plan(t[0]), in_plan(t[1]), in_plan(t[2]));
  if (area <= 0) return;
  Box2 box;
  for (const Vec3& corner : t) box.grow(in_plan(corner));
  const auto first = [&](double from, double origin) {
    return std::max(0, static_cast<int>(std::floor((from - origin) / lattice.step_m)));
  };
  const int last_i = std::min(lattice.columns - 1, first(box.max.x, lattice.box.min.x));
  const int last_j = std::min(lattice.rows - 1, first(box.max.y, lattice.box.min.y));
  for (int j = first(box.min.y, lattice.box.min.y); j <= last_j; ++j) {
    for (int i = first(box.min.x, lattice.box.min.x); i <= last_i; ++i) {
      const Vec2 p = lattice.middle(i, j);
      const double a = twice_area_m2(p, in_plan(t[1]), in_plan(t[2])),
                   b = twice_area_m2(in_plan(t[0]), p, in_plan(t[2]));
      const double c = area - a - b;
      if (a < 0 || b < 0 || c < 0) continue;
      double& lowest = lattice.lowest_m[static_cast<std::size_t>(j) * static_cast<std::size_t>(lattice.columns) +
                                        static_cast<std::size_t>(i)];
      lowest = std::min(lowest, (a * t[0].z + b * t[1].z + c * t[2].z) / area);
    }
  }
}

/// Edges whose both ends have the coordinate; a vertical triangle has none that the ground would miss.
template <typename Coordinate>
std::vector<BorderEdge> border_edges(const bake::BakedTile& tile, std::span<const OsmId> leaving, double at,
                                     Coordinate coordinate) {
  std::vector<BorderEdge> edges;
  for_each_ground_triangle(tile, leaving, [&](const Corners& t) {
    if (twice_area_m2(in_plan(t[0]), in_plan(t[1]), in_plan(t[2])) <= 0) return;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 a = t[i], b = t[(i + 1) % 3];
      if (coordinate(a) == at && coordinate(b) == at) edges.push_back(a < b ? BorderEdge{a, b} : BorderEdge{b, a});
    }
  });
  std::ranges::sort(edges);
  return edges;
}

/// The ground may lie on any layer.
double off_m(const ground::Heights& heights, double z) {
  double least_m = std::numeric_limits<double>::infinity();
  for (const double height : heights) least_m = std::min(least_m, std::abs(z - height));
  return least_m;
}

}  // namespace

GroundSamples sample_ground(const bake::BakedTile& tile, std::span<const OsmId> leaving, const ground::Carving& carving,
                            const Box2& box, double step_m) {
  Lattice lattice = lattice_of(box, step_m);
  for_each_ground_triangle(tile, leaving, [&](const Corners& corners) { lower(lattice, corners); });

  GroundSamples samples;
  samples.count = lattice.lowest_m.size();
  for (int j = 0; j < lattice.rows; ++j) {
    for (int i = 0; i < lattice.columns; ++i) {
      const double z = lattice.lowest_m[static_cast<std::size_t>(j) * static_cast<std::size_t>(lattice.columns) +
                                        static_cast<std::size_t>(i)];
      if (std::isinf(z)) {
        ++samples.uncovered;
      } else {
        samples.error_m = std::max(samples.error_m, off_m(ground::heights_at(carving, lattice.middle(i, j)), z));
      }
    }
  }
  return samples;
}

std::vector<BorderEdge> border_edges_along_x(const bake::BakedTile& tile, std::span<const OsmId> leaving, double at) {
  return border_edges(tile, leaving, at, [](Vec3 p) { return p.x; });
}

std::vector<BorderEdge> border_edges_along_y(const bake::BakedTile& tile, std::span<const OsmId> leaving, double at) {
  return border_edges(tile, leaving, at, [](Vec3 p) { return p.y; });
}

}  // namespace citykiln::commands
