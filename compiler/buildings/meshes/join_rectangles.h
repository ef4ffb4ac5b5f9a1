// Joins rectangles that lie side by side in one plane. Splits cut a wall into floors, columns, piers and sills; most of
// these pieces look alike, and a rectangle takes two triangles whatever its size.
//
//   +---+---+---+      +---+---+---+      1. one above the other: across level sides
//   | a | w | a |      |   | w |   |      2. beside each other: across the other sides
//   +---+---+---+  →   | a +---+ a |      3. again, until no two rectangles share a whole side
//   | a | a | a |      |   | a |   |      a, w: faces of two appearances
//   +---+---+---+      +---+---+---+
#pragma once

#include <vector>

#include "grammars/shapes/face.h"

namespace citykiln::buildings {

/// A face of a derivation.
struct DerivedFace {
  grammars::Face face;
  double detail_distance_m = 0;  ///< Terminal::detail_distance_m.
};

/// Returns the faces, with rectangles joined that share a whole side and whose union is a rectangle.
///
/// @param faces  All have one appearance.
/// Guarantees: the corners of a joined rectangle are corners of its parts, bit for bit; the other corners of the parts
/// are within 2^-14 m of its sides for each part that was added, so that the union of all faces stays the same to that.
/// A joined rectangle has the greatest detail_distance_m of its parts. The set of results does not depend on the order
/// of `faces`; a result stands where the first of its parts stood. Faces that are not rectangles stay.
/// Bad input: of rectangles that overlap, only one is joined. O(n log n) for each repetition of steps 1 and 2, of which
/// there are few.
std::vector<DerivedFace> join_rectangles(std::vector<DerivedFace> faces);

}  // namespace citykiln::buildings
