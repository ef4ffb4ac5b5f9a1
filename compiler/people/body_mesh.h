// The mesh of a person.
#pragma once

#include "compiler/materials/material_mesh.h"
#include "compiler/people/body.h"

namespace citykiln::people {

/// The mesh of a body and its distance from that of full detail.
struct BodyMesh {
  materials::MaterialMesh mesh;  ///< Empty if the tolerance is at least the height; then error_m is the height.
  double error_m = 0;
};

/// Returns the mesh of a look in metres. The origin is on the ground below the hips, and the person faces -y. Three
/// levels exist: about 650 triangles with limbs, shoes, hair and bag; 72 triangles without arms; 16 triangles.
///
/// Guarantees: the same bytes on every CPU; error_m <= tolerance_m. Errors are shares of the height: Hausdorff
/// distances to the first level, both ways, measured by body_mesh_test.cpp and rounded up. O(triangles).
BodyMesh body_mesh(const Look& look, double tolerance_m);

}  // namespace citykiln::people
