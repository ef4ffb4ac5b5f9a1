// Leaf clusters: fewer, larger cards. All cards of one spray in a cell of space are replaced by one.
//
//     ⌿ ⍀ │ ─ ⌿          ╱        a cell's card shows a spray where it has the area of the cell's cards, and a
//     ⍀ ─ ⌿ │ ⍀    ->   ╱         clump of sprays where it is smaller
#pragma once

#include <vector>

#include "compiler/plants/prototypes/foliage.h"

namespace citykiln::plants {

/// The new cards and their error.
struct Clusters {
  std::vector<Card> cards;
  /// A bound of the Hausdorff distance between the union of the given cards and that of the new ones.
  double error_m = 0;
};

/// Replaces a foliage's cards by one for each spray and cell of space, so that no card stands for both leaves and
/// fruit.
///
/// @param width_m  The largest width of a cell, and the largest distance by which leaves may move; > 0.
///
/// Method: space is halved until cells are no wider than width_m, every given card is within width_m of a new one, and
/// every piece of a new card is within width_m of a given one. The card of a cell has the orientation of the given card
/// nearest to the cell's centre, the mean normal and colour of all its cards, and their summed area up to that of the
/// cell. It is a clump if that is much less than the sum. Derived from stochastic simplification (Cook, Halstead,
/// Planck, Ryu, SIGGRAPH 2007), which drops cards at random.
/// Guarantees: error_m is at most width_m. A card shows leaves inside its inscribed ellipse, so distances are measured
/// from there. A single card in a cell is kept. O(n log n).
Clusters cluster(const Foliage& foliage, double width_m);

}  // namespace citykiln::plants
