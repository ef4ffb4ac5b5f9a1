// Baked facade textures: details that a coarse level omits are rendered onto the faces that it keeps.
#pragma once

#include <memory>
#include <vector>

#include "compiler/impostor/impostor.h"
#include "compiler/materials/material_mesh.h"
#include "grammars/derivation/derive.h"

namespace citykiln::buildings {

struct DetailedFacades;  // facade_elements.h

/// A face with its texture. Texture coordinates of the mesh are metres from the corner of the first texel.
struct TexturedFace {
  impostor::SharedPicture picture;
  materials::MaterialMesh mesh;
};

/// Returns a face with a picture and without triangles.
TexturedFace textured_by(impostor::SharedPicture picture, OsmId feature);

/// The faces of a building at a level, with baked textures where they need one.
struct FacadeMeshes {
  std::vector<materials::MaterialMesh> meshes;  ///< Faces of one colour: one mesh per material and tint, sorted.
  std::vector<TexturedFace> textured_faces;     ///< In the order of the terminals.
  double error_m = 0;  ///< The largest distance between the two rails of a railing and the terminal that they replace.
};

/// Returns the terminals' faces with the appearance of a more detailed model of the same building.
///
/// @param texel_m  The texel size of the textures. Details are rendered up to this far behind a face and up to
/// min(texel_m, 2 m) in front of it; farther in front there may be another wing.
/// @param tolerance_m  The tolerance of the derivation, which FacadeMeshes::error_m does not exceed.
///
/// At tolerances with Detail::kFacadeRows windows and doors are rectangles in front of the faces (facade_rows.h), and
/// faces show the detailed model without windows and doors. There a face that is to three quarters of one material, and
/// has no other windows, is a mesh of this material with the mean colour as tint.
///
/// The first that fits decides what a face becomes:
/// - two rails along its longer sides, if it is a rectangle that the detailed model covers to less than half (a
///   railing) and this stays within the tolerance;
/// - a mesh of one material, if this material covers the whole face (of a roof, 95 %);
/// - a mesh of the mean colour, if it has fewer than kMinTexels texels or is one texel wide, and emits no light;
/// - else a textured face.
/// Then rectangles are joined (meshes/join_rectangles.h): those of one material; and textured ones, unless
/// their pictures together have more texels than the distinct ones of the parts.
/// Faces that the detailed model does not cover and faces of more than kMaxTexelsPerFace texels keep the terminal's
/// material. Deterministic on every CPU. Cost: one impostor::render() per face, and another per joined one.
FacadeMeshes texture_facades(const grammars::Derivation& derivation, const DetailedFacades& detailed, double texel_m,
                             double tolerance_m, OsmId feature);

/// The least number of texels of a textured face. Smaller faces get the mean colour.
inline constexpr std::uint32_t kMinTexels = 9;
/// The largest number of texels of a face: 300 by 400 m at 0.5 m. Larger faces are roofs of halls.
inline constexpr std::uint32_t kMaxTexelsPerFace = 1u << 19;

/// Returns the number of times that the texels of a face's picture are halved for rendering: until samples are at most
/// 0.4 m apart (else the colour would depend on where a row of windows meets the samples), or until one more halving
/// would exceed kMaxTexelsPerFace (a face of kilometres).
std::uint32_t halvings_for(const impostor::View& view);

}  // namespace citykiln::buildings
