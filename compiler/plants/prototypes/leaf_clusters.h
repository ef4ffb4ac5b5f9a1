// Fewer and larger leaves: the cards of a cell of space become one of their area.
#pragma once

#include <vector>

#include "compiler/plants/prototypes/foliage.h"

namespace citykiln::plants {

struct Clusters {
  std::vector<Card> cards;
  double error_m = 0;  ///< Hausdorff, both ways, from the cards to the given ones.
};

/// Cards that stand for a foliage's at a tolerance.
///
/// Method: cells are halved (an octree) until the card that would stand for a cell's is within the tolerance. It lies
/// as the one nearest to their middle does, has their summed area (what of it stays within the tolerance), mean light
/// and colour. After stochastic simplification: Cook, Halstead, Planck, Ryu, SIGGRAPH 2007, which leaves out by chance.
/// Guarantees: error_m is at most the tolerance, exact from given cards to these, bounded by pieces the other way; a
/// cell of one card keeps it. O(n log n).
Clusters cluster(const Foliage& foliage, double tolerance_m);

}  // namespace citykiln::plants
