// What a level leaves out of a facade, as pictures on the faces that it keeps: a high house baked on a low one.
#pragma once

#include <vector>

#include "compiler/impostor/impostor.h"
#include "compiler/materials/material_mesh.h"
#include "grammars/derivation/derive.h"

namespace citykiln::buildings {

/// A face and its picture. The mesh has uvs: metres on the picture, from its first texel's corner.
struct TexturedFace {
  impostor::Picture picture;
  materials::MaterialMesh mesh;
};

struct FacadeMeshes {
  std::vector<materials::MaterialMesh> meshes;  ///< What one material and tint is enough for: one mesh each, in order.
  std::vector<TexturedFace> textured_faces;     ///< In the terminals' order.
  double error_m = 0;  ///< How far rails are from what the terminals that they stand for stand for.
};

/// The terminals' faces as terminal_meshes() makes them, dressed as what stands before and behind them looks.
///
/// @param looks    The same building, finer.
/// @param tolerance_m  Of the derivation: no error here is larger.
/// @param texel_m  Of pictures; of how far the finer one may stand behind a face, and before it up to 2 m: farther
///                 before a wall of a court stands the other wing.
///
/// A face on which all is of one material and tint takes them, and a roof where nearly all is; where nothing shines,
/// what is smaller than kMinTexels, or a texel wide, takes the mean colour, as paint on what most of it is made
/// of; the rest have pictures, with slopes where texels are under 2 m. Faces before which nothing stands, or with more
/// than kMaxTexelsPerFace, look as the terminal does. Of a rectangle that is mostly holes, as a railing, two rails are
/// left, as large as what is there, where that is within the tolerance. The same bytes on every CPU. Total. Cost:
/// imprint()'s, a face.
FacadeMeshes texture_facades(const grammars::Derivation& derivation, const impostor::Model& looks, double texel_m,
                             double tolerance_m, OsmId feature);

/// From here on a picture says more than its mean does.
inline constexpr std::uint32_t kMinTexels = 9;
/// A face of 300 by 400 m at half a metre; larger ones are roofs of halls.
inline constexpr std::uint32_t kMaxTexelsPerFace = 1u << 19;

}  // namespace citykiln::buildings
