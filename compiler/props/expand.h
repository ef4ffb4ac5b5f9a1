// From lines and points to walls, hedges and lamps.
#pragma once

#include <span>
#include <vector>

#include "compiler/geometry/placement.h"
#include "compiler/ground/grading/carving.h"
#include "compiler/materials/dressed_mesh.h"
#include "compiler/props/recipe.h"
#include "compiler/props/street_lamps.h"

namespace citykiln::props {

struct Expanded {
  std::vector<materials::DressedMesh> meshes;
  double error_m = 0;
};

/// A wall, fence or hedge as a band that follows the ground, split where the field bends. Dropped, with its height as
/// error, where it is lower than the tolerance.
Expanded expand(const Barrier& barrier, const ground::Carving& ground, double tolerance_m);

/// A lamp 1 m tall: its foot at the origin, its arm a fifth as long along +x; scale is the height. Every part is
/// closed; at most 80 triangles. Cut so that a lamp of `height_m` is within the tolerance, by the error stated; empty
/// where the lamp itself is lower than the tolerance.
Expanded lamp_mesh(LampKind kind, double height_m, double tolerance_m);

/// On the ground, turned so that +x points where the lamp faces.
Placement place(const StreetLamp& lamp, const ground::Carving& ground);

}  // namespace citykiln::props
