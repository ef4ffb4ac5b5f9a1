// Adds the supports of a bridge deck: piers, and an abutment at each end on the ground. A rib is a straight line across
// the deck at one distance along its axis (ribs.h).
//
//     ==|======================|==  deck
//     |_|    _|__|_   _|__|_   |_|  cap beams, columns
//     ~~~~~~  |  |     |  |  ~~~~~
#pragma once

#include <span>

#include "compiler/structures/deck_dimensions.h"

namespace citykiln::structures {

/// Half the size of a pier's foot, across the deck and along it, metres.
struct PierFoot {
  double half_across_m = 0, half_along_m = 0;
};
/// Returns the size of the foot of a pier under a deck of these dimensions.
PierFoot foot_of(const DeckDimensions& dimensions);

/// Adds a pier under the deck, in plane metres, z up: one wall under a narrow deck, columns with a cap beam under a
/// wide one. Each part is a closed body.
///
/// @param ribs  In order along the deck, at least two; here and below.
/// @param pier  Its position along the way and the height of its lower end.
void add_pier(std::span<const Rib> ribs, const DeckDimensions& dimensions, const Pier& pier, Mesh& mesh);

/// Adds an abutment: the closed block on which an end of the deck rests.
/// @param is_begin  True for the end at the first rib, else at the last.
void add_abutment(std::span<const Rib> ribs, const DeckDimensions& dimensions, bool is_begin, Mesh& mesh);

/// Height of an abutment from the underside of the slab down, and its length along the deck.
inline constexpr double kAbutment_m = 2.5, kAbutmentLength_m = 1;

}  // namespace citykiln::structures
