// Spatial index of the straight pieces of all decks.
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
  BoxGrid grid;  ///< Finds pieces by their boxes.
};

/// Returns the index of the pieces of all bridges.
/// @param margin_m  The boxes of the pieces contain the deck between its parapets and this margin around it.
DeckIndex index_decks(std::span<const Span> bridges, double margin_m);

}  // namespace citykiln::structures
