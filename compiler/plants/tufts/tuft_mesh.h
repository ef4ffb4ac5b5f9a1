// Meshes of tufts.
#pragma once

#include <vector>

#include "compiler/materials/material_mesh.h"
#include "compiler/plants/tufts/tuft_form.h"

namespace citykiln::plants {

/// Linear reflectance of red, green and blue.
struct LeafColour {
  double red = 0, green = 0, blue = 0;
};

/// The mesh of a tuft 1 m tall, with its foot at the origin and z up. Equal arguments give equal meshes. Blades are
/// darker at their feet, and have normals that point up, so that they are as light as the ground. At most 100
/// triangles.
/// @param leaf  The colour of blades and leaves. Petals have their own.
std::vector<materials::MaterialMesh> tuft_mesh(TuftForm form, std::uint8_t variant, const LeafColour& leaf);

}  // namespace citykiln::plants
