// A spatial index of bridge decks, for finding the decks near a place. A deck is divided at its ribs into straight
// pieces. A rib is a straight line across the deck at one distance along its axis (ribs.h).
#pragma once

#include <vector>

#include "compiler/geometry/box_grid.h"
#include "compiler/structures/deck_dimensions.h"

namespace citykiln::structures {

/// The part of a deck between two neighbouring ribs.
struct DeckPiece {
  std::uint32_t bridge = 0;        ///< Index of the bridge in the argument of index_decks().
  Rib from, to;                    ///< The ribs at the begin and at the end of the piece.
  double left_m = 0, right_m = 0;  ///< From the axis to the inner faces of the parapets.
};

/// Pieces of all decks, with their index.
struct DeckIndex {
  std::vector<DeckPiece> pieces;  ///< Bridge by bridge, along each bridge.
  BoxGrid grid;                   ///< Finds indices into `pieces` by the boxes of the pieces.
};

/// Returns the index of all pieces of the decks. O(n).
/// @param bridges   Bridges as recipes: roads with profiles of heights.
/// @param margin_m  Distance by which the box of a piece is larger than the deck between its parapets, on each side.
DeckIndex index_decks(std::span<const Span> bridges, double margin_m);

}  // namespace citykiln::structures
