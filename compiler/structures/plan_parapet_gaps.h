// Finds parapet gaps: a deck has no parapet along the part of its edge that lies in another deck.
//
//     =====|            |=====
//          |    gap     |          each edge lies within the other deck, at about the same height
//     =====+____________+=====
#pragma once

#include <vector>

#include "compiler/structures/recipe.h"

namespace citykiln::structures {

/// Two decks whose roads differ in height by less than this are one surface.
inline constexpr double kSameSurface_m = 0.6;

/// Returns the bridges with their parapet gaps. Edges are sampled every 0.25 m. The gaps do not depend on the order of
/// the bridges. O(length · decks near).
std::vector<Span> find_parapet_gaps(std::vector<Span> bridges);

}  // namespace citykiln::structures
