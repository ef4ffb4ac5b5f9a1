// Generates barriers and street lamps.
#pragma once

#include <span>
#include <vector>

#include "compiler/geometry/placement.h"
#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/materials/material_mesh.h"
#include "compiler/props/recipe.h"
#include "compiler/props/street_lamps.h"

namespace citykiln::props {

/// The meshes of a prop, and their distance from the prop in full detail.
struct GeneratedProp {
  std::vector<materials::MaterialMesh> meshes;
  double error_m = 0;
};

/// Generates a wall, fence or hedge: a rectangular cross-section swept along its axis, which is draped over the ground
/// to a share of the tolerance, which is part of the error. A railing has posts and rails (railing_mesh.h). Walls end
/// in a coping, which is left out where the tolerance is larger than what stands over; that is then the error. A
/// barrier that is not higher than the tolerance gets no mesh, and its height is the error.
GeneratedProp generate(const Barrier& barrier, const ground::GradedTerrain& ground, double tolerance_m);

/// Generates a lamp of 1 m height, to be scaled by height_m: its foot at the origin, its arm 0.21 m long along +x.
/// Every part is closed; at most 80 triangles. GeneratedProp::error_m is the error of the scaled lamp, within the
/// tolerance. A lamp that is not higher than the tolerance gets no mesh, and its height is the error. height_m > 0.
GeneratedProp lamp_mesh(LampKind kind, double height_m, double tolerance_m);

/// Returns the placement of a lamp on the ground, with +x in the direction that the lamp faces.
Placement place(const StreetLamp& lamp, const ground::GradedTerrain& ground);

}  // namespace citykiln::props
