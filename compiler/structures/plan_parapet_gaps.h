// Where decks run into each other, their parapets stop.
//
//     =====|            |=====
//          |   open     |          both lie within the other's edges, at about the same height
//     =====+____________+=====
#pragma once

#include <vector>

#include "compiler/structures/recipe.h"

namespace citykiln::structures {

/// Decks whose roads differ by less in height are one surface.
inline constexpr double kSameSurface_m = 0.6;

/// The bridges with their openings: wherever the parapet on one of a deck's edges would stand on another deck, looked
/// at every quarter of a metre. Does not depend on the order of bridges. O(length · decks near).
std::vector<Span> find_parapet_gaps(std::vector<Span> bridges);

}  // namespace citykiln::structures
