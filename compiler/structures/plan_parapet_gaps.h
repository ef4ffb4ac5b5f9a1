// Parapet gaps: where a deck's edge lies on another deck, it has no parapet.
//
//     =====|            |=====
//          |    gap     |          each edge lies within the other deck, at about the same height
//     =====+____________+=====
#pragma once

#include <vector>

#include "compiler/structures/recipe.h"

namespace citykiln::structures {

/// Decks whose roads differ by less in height form one surface.
inline constexpr double kSameSurface_m = 0.6;

/// Returns the bridges with their parapet gaps, sampled every 0.25 m. The result does not depend on the order of the
/// bridges. O(length · decks near).
std::vector<Span> find_parapet_gaps(std::vector<Span> bridges);

}  // namespace citykiln::structures
