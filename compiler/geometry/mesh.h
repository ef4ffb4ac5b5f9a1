// Indexed triangle meshes.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "compiler/geometry/vec.h"

namespace citykiln {

using Triangle = std::array<std::uint32_t, 3>;

/// Positions in plane metres on the 2^-10 m grid; triangles counter-clockwise from outside.
struct Mesh {
  std::vector<Vec3> positions;
  std::vector<Vec3> normals;  ///< Unit length, one for each position; empty: flat shading.
  std::vector<Triangle> triangles;
};

/// Adds two triangles for the quadrilateral a, b, c, d, split from a to c.
inline void add_quad(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  mesh.triangles.push_back({a, b, c});
  mesh.triangles.push_back({a, c, d});
}

}  // namespace citykiln
