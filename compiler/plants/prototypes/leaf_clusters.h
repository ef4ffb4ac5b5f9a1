// Leaf clusters: fewer, larger cards; the cards of a cell of space are replaced by one.
//
//     ⌿ ⍀ │ ─ ⌿          ╱        a cell's card shows a spray where it has the area of the cell's cards, and a
//     ⍀ ─ ⌿ │ ⍀    ->   ╱         clump of sprays where it is smaller
#pragma once

#include <vector>

#include "compiler/plants/prototypes/foliage.h"

namespace citykiln::plants {

struct Clusters {
  std::vector<Card> cards;
  double error_m = 0;  ///< Bound of the Hausdorff distance between the given cards and the new ones, as sets.
};

/// Replaces a foliage's cards by one for each cell of space.
///
/// @param width_m  Of a cell, and how far leaves may move; > 0.
///
/// Method: cells are halved until they are no wider than the width, and on, until every given card is within the width
/// of a new one and every piece of a new card within the width of a given one. A cell's card has the orientation of the
/// card nearest to the cell's centre, the mean normal and colour of its cards, and their summed area up to that of the
/// cell; it is a clump where that is much less. After stochastic simplification (Cook, Halstead, Planck, Ryu,
/// SIGGRAPH 2007), which drops cards at random.
/// Guarantees: error_m is at most the width. A card shows leaves in the ellipse within it; distances are measured from
/// there. A single card in a cell is kept. O(n log n).
Clusters cluster(const Foliage& foliage, double width_m);

}  // namespace citykiln::plants
