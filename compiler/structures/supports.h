// Supports of a deck: piers, and abutments where it ends on the ground.
//
//     ==|======================|==  deck
//     |_|    _|__|_   _|__|_   |_|  cap beams, columns
//     ~~~~~~  |  |     |  |  ~~~~~
#pragma once

#include <span>

#include "compiler/structures/deck_dimensions.h"

namespace citykiln::structures {

/// Half the size of a pier's foot, across the deck and along it.
struct PierFoot {
  double half_across_m = 0, half_along_m = 0;
};
PierFoot foot_of(const DeckDimensions& dimensions);

/// Adds a pier under the deck: a wall under narrow decks, columns with a cap beam under wide ones. Each part is closed.
void add_pier(std::span<const Rib> ribs, const DeckDimensions& dimensions, const Pier& pier, Mesh& mesh);

/// Adds the block on which an end of the deck rests. Closed.
void add_abutment(std::span<const Rib> ribs, const DeckDimensions& dimensions, bool is_begin, Mesh& mesh);

/// The height of an abutment below the slab, and its length along the deck.
inline constexpr double kAbutment_m = 2.5, kAbutmentLength_m = 1;

}  // namespace citykiln::structures
