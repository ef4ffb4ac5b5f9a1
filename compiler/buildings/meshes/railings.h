// Railings of balconies: bars under a rail. A face of Material::kRailing represents a whole railing. Its
// texture has holes between
// the bars (materials::TexturePattern::kBars); at fine tolerances bars and rail are faces of their own.
//
//   =============    rail                The texture is stretched to the face's height, and along the face to a whole
//   | | | | | | |    bars, some 14 cm    number of bars, with one at each end.
//   | | | | | | |    apart
//                    gap
#pragma once

#include <vector>

#include "compiler/materials/material_mesh.h"
#include "grammars/shapes/face.h"

namespace citykiln::buildings {

/// Adds the texture coordinates of a railing for the last positions of the mesh, which have none yet and are points of
/// the face. Multiples of materials::kTextureCoordinateStep_m. Precondition: the face has an area.
void add_railing_uvs(const grammars::Face& railing, materials::MaterialMesh& mesh);

/// Returns the bars of a railing, which are seen from both sides, and the front, the back and the top of its rail, in
/// the places where the texture has them. A railing that is no rectangle gets those of its bounding rectangle.
/// Precondition: the face has an area. O(bars).
std::vector<grammars::Face> parts_of_railing(const grammars::Face& railing);

}  // namespace citykiln::buildings
