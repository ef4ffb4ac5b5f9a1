// Leaf clusters: fewer, larger cards; the cards of a cell of space are replaced by one of their area.
#pragma once

#include <vector>

#include "compiler/plants/prototypes/foliage.h"

namespace citykiln::plants {

struct Clusters {
  std::vector<Card> cards;
  double error_m = 0;  ///< Hausdorff distance to the given cards.
};

/// Replaces a foliage's cards at a tolerance.
///
/// Method: octree cells are split until one card can replace a cell's cards within the tolerance. It has the
/// orientation of the card nearest to their centre, their summed area or 70 % of it, and their mean normal and colour.
/// After stochastic simplification (Cook, Halstead, Planck, Ryu, SIGGRAPH 2007), which drops cards at random.
/// Guarantees: error_m is at most the tolerance; it is exact from given cards to new ones, and bounded by pieces the
/// other way. A single card in a cell is kept. O(n log n).
Clusters cluster(const Foliage& foliage, double tolerance_m);

}  // namespace citykiln::plants
