// Rows of windows: on levels that have a wall as one face, its windows and doors are rectangles just before it. Equal ones
// at equal distances are one rectangle with one picture, which also shows the wall between them, if this saves bytes.
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

/// The number of columns and of rows of windows on a picture. Longer rows repeat it, shorter ones show a part of it.
inline constexpr std::uint32_t kWindowsOfPicture = 8;

/// An element on a wall.
struct ElementOnWall {
  Box2 box;                  ///< Metres in the frame of the wall's face.
  SharedPackedPicture seen;  ///< PlacedElement::picture.
  double moved_m = 0;        ///< How far it was moved along the wall's normal to lie in its plane.
};

/// A wall and all that is to be shown on it.
struct WallWithElements {
  grammars::FaceFrame frame;
  impostor::Texel colour;  ///< Of the wall between the elements.
  std::vector<ElementOnWall> elements;
};

/// Returns the elements that lie on each of the faces, in the faces' order. An element lies on the nearest face that is
/// parallel to it, at most `reach_m` away, and has room for all of it; without one it is left out. O(faces × elements).
std::vector<std::vector<ElementOnWall>> elements_on(std::span<const grammars::Face> faces,
                                                    std::span<const PlacedElement> elements, double reach_m);

/// The sizes of rows at a tolerance, metres.
struct RowSizes {
  double texel_m;           ///< The side of a texel on their pictures.
  double before_m;          ///< How far they stand before the wall, lest they flicker.
  double same_m;            ///< Lengths and distances that differ by no more are equal.
  double texel_on_atlas_m;  ///< The side that the atlas of the level gives to all its texels: the unit of uvs.
};
/// Returns the sizes at a tolerance.
RowSizes row_sizes(double tolerance_m);

/// Returns the windows and doors of a building's walls, one TexturedFace for each picture.
///
/// The picture of several has the pictures that elements of this size have most, each about as often as in the
/// building; an element alone has its own. Deterministic on every CPU. O(n² of a wall + texels).
std::vector<TexturedFace> rows_of(std::span<const WallWithElements> walls, const RowSizes& sizes, OsmId feature);

}  // namespace citykiln::buildings
