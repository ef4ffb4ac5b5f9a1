// The mesh of a person.
#pragma once

#include "compiler/materials/material_mesh.h"
#include "compiler/people/body.h"

namespace citykiln::people {

/// The mesh of a body and its distance from that of full detail.
struct BodyMesh {
  materials::MaterialMesh mesh;  ///< Without triangles where the tolerance is not below the height.
  double error_m = 0;
};

/// Returns the mesh of a look. The origin is on the ground below the hips, and the person faces -y. There are three
/// levels: some 650 triangles with limbs, shoes, hair and bag; 72, without arms; and 16.
///
/// Guarantees: the same bytes on every CPU; error_m <= tolerance_m. Errors are shares of the height: Hausdorff
/// distances to the first level, both ways, measured by body_mesh_test.cpp and rounded up. O(triangles).
BodyMesh body_mesh(const Look& look, double tolerance_m);

}  // namespace citykiln::people
