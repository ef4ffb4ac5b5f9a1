// Makes meshes of a derivation (the result of facade rules): triangulates the faces of its terminals (shapes that no
// rule replaces) and groups them by
// material and tint.
#pragma once

#include <map>
#include <vector>

#include "compiler/buildings/meshes/join_rectangles.h"
#include "compiler/materials/material_mesh.h"
#include "grammars/derivation/derive.h"

namespace citykiln::buildings {

/// Returns the material and tint of a terminal's appearance. O(rows).
///
/// material.name is the name of a material in snake case ("roof_tile"); an unknown name is plaster. The colour becomes
/// a tint (paint_colour.h), on kPaint if the material is too dark for it; white, the default, leaves the material
/// untinted. A colour never changes glass to kPaint.
materials::SurfaceMaterial surface_material_of(const grammars::Appearance& appearance);

/// Returns the surfaces of a derivation, by index into Derivation::appearances. O(appearances).
std::vector<materials::SurfaceMaterial> surfaces_of(const grammars::Derivation& derivation);

/// Adds the triangles of a face. Faces without area add nothing.
void add_face(const grammars::Face& face, Mesh& mesh);

/// Adds the triangles of a face, with texture coordinates if the material has a texture. All faces of the MaterialMesh
/// must be added by this overload, so that each position has coordinates.
void add_face(const grammars::Face& face, materials::MaterialMesh& mesh);

/// Returns the terminals' faces by material and tint. Terminals without faces, such as assets, and elements
/// (facade_elements.h) add nothing. O(n log n).
std::map<materials::SurfaceMaterial, std::vector<DerivedFace>> faces_by_surface(const grammars::Derivation& derivation);

/// Returns faces as one mesh per material and tint, as terminal_meshes() does, without joining any.
std::vector<materials::MaterialMesh> meshes_of(
    const std::map<materials::SurfaceMaterial, std::vector<DerivedFace>>& faces_of, OsmId feature, double tolerance_m);

/// Returns the terminals' faces as one mesh per material and tint, sorted by material and tint, with rectangles joined
/// (join_rectangles.h).
///
/// At tolerances with Detail::kRailingBars, the faces of Material::kRailing are replaced by their bars (railings.h).
///
/// Guarantees: triangles are planar and counter-clockwise seen from outside. The vertices of a simple face are its
/// points, bit for bit, and its triangles have its area; of rectangles that are joined, the corners of the union.
/// Texture coordinates run along the lower edge of a face and up the face, so that coplanar faces continue the texture.
/// Deterministic. Ignores faces without area, assets, and the terminals' own texture frames. O(n log n).
std::vector<materials::MaterialMesh> terminal_meshes(const grammars::Derivation& derivation, OsmId feature,
                                                     double tolerance_m);

}  // namespace citykiln::buildings
