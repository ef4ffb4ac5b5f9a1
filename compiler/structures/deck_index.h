// Spatial index of all decks, in straight pieces.
#pragma once

#include <vector>

#include "compiler/geometry/box_grid.h"
#include "compiler/structures/deck_dimensions.h"

namespace citykiln::structures {

/// A straight piece of a deck.
struct DeckPiece {
  std::uint32_t bridge = 0;  ///< Index of the span.
  Rib from, to;
  double left_m = 0, right_m = 0;  ///< From the axis to the inner faces of the parapets.
};

struct DeckIndex {
  std::vector<DeckPiece> pieces;
  BoxGrid grid;  ///< Of the pieces' boxes.
};

/// @param margin_m  By which the boxes of the pieces are larger than the road between the parapets.
DeckIndex index_decks(std::span<const Span> bridges, double margin_m);

}  // namespace citykiln::structures
