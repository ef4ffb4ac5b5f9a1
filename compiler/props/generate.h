// From lines and points to walls, hedges and lamps.
#pragma once

#include <span>
#include <vector>

#include "compiler/geometry/placement.h"
#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/materials/material_mesh.h"
#include "compiler/props/recipe.h"
#include "compiler/props/street_lamps.h"

namespace citykiln::props {

struct GeneratedProp {
  std::vector<materials::MaterialMesh> meshes;
  double error_m = 0;
};

/// A wall, fence or hedge as a band that follows the ground, split where the field bends. Dropped, with its height as
/// error, where it is lower than the tolerance.
GeneratedProp generate(const Barrier& barrier, const ground::GradedTerrain& ground, double tolerance_m);

/// A lamp 1 m tall: its foot at the origin, its arm a fifth as long along +x; scale is the height. Every part is
/// closed; at most 80 triangles. Cut so that a lamp of `height_m` is within the tolerance, by the error stated; empty
/// where the lamp itself is lower than the tolerance.
GeneratedProp lamp_mesh(LampKind kind, double height_m, double tolerance_m);

/// On the ground, turned so that +x points where the lamp faces.
Placement place(const StreetLamp& lamp, const ground::GradedTerrain& ground);

}  // namespace citykiln::props
