// Packs rectangles of texels into an image whose sides are powers of two.
//
//     +-------+-------+---+---+      shelves, filled from the highest boxes to the lowest
//     |       |       |   |   |
//     |       +---+---+---+---|
//     +---+---+---+---+ free  |
//     |   |   |   |   |       |
//     +---+---+---+---+-------+
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace citykiln::impostor {

struct BoxSize {
  std::uint32_t columns = 0, rows = 0;
};

struct BoxPlace {
  std::uint32_t column = 0, row = 0;  ///< The position of the texel at the top left.
};

struct PackedBoxes {
  std::vector<BoxPlace> places;  ///< One per box.
  std::uint32_t columns = 0, rows = 0;
};

/// Packs boxes into an image.
/// @param boxes  With sides > 0.
///
/// Method: shelf packing by decreasing height, into the width that gives the least area, and among equal areas the
/// squarest image. Guarantees: boxes do not overlap; if the sides of all boxes are multiples of a power of two, so are
/// the positions of boxes; columns and rows are powers of two, 0 without boxes. O(n log n).
PackedBoxes pack_boxes(std::span<const BoxSize> boxes);

}  // namespace citykiln::impostor
