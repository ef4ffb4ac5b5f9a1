// What a rule made, dressed: names and colours of looks become materials and tints, faces become triangles.
#pragma once

#include <vector>

#include "compiler/materials/material_mesh.h"
#include "grammars/derivation/derive.h"

namespace citykiln::buildings {

/// What surfaces are made of that look so, and how they are tinted.
struct SurfaceMaterial {
  materials::Material material{};
  materials::Tint tint = materials::kNoTint;
  auto operator<=>(const SurfaceMaterial&) const = default;
};

/// material.name is a row of the material table in small letters ("roof_tile"); another name is plaster. A colour is
/// paint over it (painted.h), or where the material is too dark for it, kPaint; white, which nothing has set, leaves
/// the material its own. Glass is tinted as far as it can be. O(rows).
SurfaceMaterial surface_material_of(const grammars::Appearance& look);

/// Adds a face's triangles, with its own points. Faces without area add nothing.
void add_face(const grammars::Face& face, Mesh& mesh);

/// The terminals' faces as meshes, one a material and tint, in that order.
///
/// Guarantees: flat triangles, counter-clockwise from outside; of a face that does not cross itself the triangles'
/// points are its points, bit for bit, and their area is the face's. What has a texture has places on it (uvs): along a
/// face's foot and up it, so that faces of one plane show one picture. The same bytes for the same derivation. Total:
/// faces without area add nothing; assets, and the terminals' own texture frames, are left out. O(n log n); faces
/// without holes that turn left at all corners but one, O(n).
std::vector<materials::MaterialMesh> terminal_meshes(const grammars::Derivation& derivation, OsmId feature);

/// Adds a face as terminal_meshes() does: with places on the material's texture, if it has one. Then all of the mesh
/// has to be added so.
void add_face(const grammars::Face& face, materials::MaterialMesh& dressed);

}  // namespace citykiln::buildings
