// What a deck stands on: piers, and abutments where it comes down.
//
//     ==|======================|==  deck
//     |_|    _|__|_   _|__|_   |_|  cap beams, columns
//     ~~~~~~  |  |     |  |  ~~~~~
#pragma once

#include <span>

#include "compiler/structures/deck_dimensions.h"

namespace citykiln::structures {

/// How long and how broad a pier's foot is, square to the deck and along it: what has to be free.
struct PierFoot {
  double half_across_m = 0, half_along_m = 0;
};
PierFoot foot_of(const DeckDimensions& shape);

/// Adds a pier under the deck: one wall for narrow decks, columns with a beam for wide ones. Each part is closed.
void add_pier(std::span<const Rib> ribs, const DeckDimensions& shape, const Pier& pier, Mesh& mesh);

/// Adds the block on which the deck's end lies, down to where the bank hides it. Closed.
void add_abutment(std::span<const Rib> ribs, const DeckDimensions& shape, bool is_begin, Mesh& mesh);

/// How far below the slab an abutment reaches, and how far along.
inline constexpr double kAbutment_m = 2.5, kAbutmentLength_m = 1;

}  // namespace citykiln::structures
