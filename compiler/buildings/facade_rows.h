// Rows of windows. On levels where a wall is one face, its windows and doors are rectangles just in front of it. Equal
// ones at equal distances are one rectangle with one picture, which also shows the wall between them, if this saves
// bytes.
//
//     .--.  .--.  .--.  .--.
//     |__|  |__|  |__|  |__|      eight windows of one size,
//     .--.  .--.  .--.  .--.      two triangles
//     |__|  |__|  |__|  |__|
#pragma once

#include <span>
#include <vector>

#include "compiler/buildings/facade_elements.h"

namespace citykiln::buildings {

/// A picture has at most this many columns of windows and as many rows. Larger grids repeat it, smaller ones show a
/// part.
inline constexpr std::uint32_t kWindowsOfPicture = 8;

/// An element on a wall.
struct ElementOnWall {
  Box2 box;                      ///< Metres, in WallWithElements::frame.
  impostor::SharedPicture seen;  ///< PlacedElement::picture.
  double moved_m = 0;            ///< The distance by which it was moved into the wall's plane.
};

/// A wall and its elements.
struct WallWithElements {
  grammars::FaceFrame frame;
  impostor::Texel colour;  ///< The surface of the wall between the elements.
  std::vector<ElementOnWall> elements;
};

/// Returns the elements of each face. An element belongs to the nearest face that looks the same way to within 2.5
/// degrees, is nearer than `reach_m` and contains its outline to within 1 cm; of two as near, to the first. Elements
/// without such a face are left out. O(faces × elements).
std::vector<std::vector<ElementOnWall>> elements_on(std::span<const grammars::Face> faces,
                                                    std::span<const PlacedElement> elements, double reach_m);

/// The sizes of rows at a tolerance, metres.
struct RowSizes {
  double texel_m;           ///< The side of a texel on their pictures.
  double before_m;          ///< The distance in front of the wall, so that viewers do not mix both.
  double same_m;            ///< Lengths and distances that differ by no more are equal.
  double texel_on_atlas_m;  ///< The texel size that the atlas of the level states: uvs are texels times this.
};
/// Returns the sizes at a tolerance.
RowSizes row_sizes(double tolerance_m);

/// Returns the windows and doors of a building's walls, one TexturedFace for each picture, and none without elements.
///
/// A rectangle for one element shows that element. The picture of several mixes the commonest elements of their size,
/// in the proportions in which such rectangles have them. No rectangle covers another. Deterministic on every CPU.
/// Cost: O(n²) for a wall with n elements, and O(texels).
/// @param feature  The map element that the meshes belong to.
std::vector<TexturedFace> rows_of(std::span<const WallWithElements> walls, const RowSizes& sizes, OsmId feature);

}  // namespace citykiln::buildings
