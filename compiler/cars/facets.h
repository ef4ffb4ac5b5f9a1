// Triangles of a car with their surfaces, from which meshes with creased normals are made.
#pragma once

#include <span>
#include <vector>

#include "compiler/geometry/vec.h"
#include "compiler/materials/material_mesh.h"

namespace citykiln::cars {

/// The appearance of a triangle. The paint of a car is apart from all else, which cars of every colour share.
struct Surface {
  materials::Material material{};
  materials::Tint tint = materials::kNoTint;
  bool is_paint = false;
  bool operator==(const Surface&) const = default;
};

struct Facet {
  std::array<Vec3, 3> corners;
  Surface surface;
};

/// The triangles of a car, counter-clockwise from outside.
struct Facets {
  std::vector<Facet> all{};

  /// Adds a triangle, or a quadrilateral split from a to c. Triangles without area are left out.
  void add(Vec3 a, Vec3 b, Vec3 c, const Surface& surface);
  void add(Vec3 a, Vec3 b, Vec3 c, Vec3 d, const Surface& surface);
  /// Adds a quadrilateral and its mirror image beyond x = 0.
  void add_twice(Vec3 a, Vec3 b, Vec3 c, Vec3 d, const Surface& surface);
  /// Adds a box between two corners.
  void add_box(Vec3 low, Vec3 high, const Surface& surface);
};

/// Returns the triangles of the paint, or all others, as one mesh for each material. A vertex normal is the mean by
/// area of the normals of the triangles at that vertex, paint or not, that differ from this triangle's by less than 41
/// degrees. O(n log n + n · triangles at a vertex).
std::vector<materials::MaterialMesh> meshes_of(const Facets& facets, bool is_paint);

}  // namespace citykiln::cars
