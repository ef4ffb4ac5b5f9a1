// A wall in the plane y = 0, seen from the south, for tests of impostors.
#pragma once

#include <vector>

#include "compiler/impostor/impostor.h"

namespace citykiln::impostor {

/// A vertical rectangle that faces south, from (x0, y, z0) to (x1, y, z1).
inline materials::MaterialMesh panel(double x0, double z0, double x1, double z1, materials::Material material,
                                     double y = 0) {
  materials::MaterialMesh mesh;
  mesh.material = material;
  mesh.mesh.positions = {{x0, y, z0}, {x1, y, z0}, {x1, y, z1}, {x0, y, z1}};
  mesh.mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

/// The view from the south of a rectangle of `columns` by `rows` metres from (0, 0, 0), with texels of a metre.
inline View seen_from_south(std::uint32_t columns, std::uint32_t rows) {
  View view;
  view.corner = {0, 0, static_cast<double>(rows)};
  view.u = {1, 0, 0}, view.v = {0, 0, -1};
  view.columns = columns, view.rows = rows;
  view.before_m = view.behind_m = 1;
  return view;
}

}  // namespace citykiln::impostor
