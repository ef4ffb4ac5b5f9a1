// The volume of meshes, for tests of closed ones.
#pragma once

#include <span>

#include "compiler/materials/material_mesh.h"

namespace citykiln {

/// The volume that the meshes enclose together, negative if their triangles are clockwise from outside.
inline double volume_m3(std::span<const materials::MaterialMesh> meshes) {
  double six = 0;
  for (const auto& part : meshes)
    for (const auto& [a, b, c] : part.mesh.triangles) {
      const auto& p = part.mesh.positions;
      six += dot(p[a], cross(p[b], p[c]));
    }
  return six / 6;
}

}  // namespace citykiln
