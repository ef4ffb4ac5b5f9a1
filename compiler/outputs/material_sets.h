// Textures of artists, which replace those of citykiln.
#pragma once

#include <string>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/materials/texture.h"

namespace citykiln::outputs {

/// A texture of an artist, and who made it.
struct MaterialSet {
  materials::Texture texture;  ///< Colour, and normal and surface where the set has them.
  std::string credit, licence;
};

/// Returns the sets of a folder, in order of their materials; none for "".
///
/// The folder has one folder for each material, with its name in rule files, such as "flemish_brick". Its pictures are
/// PNG, JPEG or WebP, known by the words of their names as ambientCG and Poly Haven have them: Color or diff; NormalGL,
/// NormalDX, nor_gl or nor_dx; Roughness or rough; AO; Displacement or disp. A table materials.csv has a row for each:
///
///     material,size_m,credit,licence
///     flemish_brick,2.5,Jane Doe,CC0
///
/// Sides become the nearest power of two, at most `most_px`; size_m becomes the nearest 64 m / n
/// with a whole number n, since texture coordinates repeat after 64 m. Linear colours are scaled until their mean is
/// the colour of the material, which tints of buildings and coarse levels assume. Occlusion darkens colours.
/// Displacement gives normals where none are.
///
/// Errors, a line for each picture, row or folder that is wrong, with what was expected: a material that has no texture
/// in citykiln; a missing row, colour or table; a picture that cannot be decoded, is not square, or not as large as the
/// colours. Never crashes.
Result<std::vector<MaterialSet>> read_material_sets(const std::string& folder, std::uint32_t most_px);

}  // namespace citykiln::outputs
