// Lot borders: the lines along which a field's labels differ.
#pragma once

#include <utility>
#include <vector>

#include "compiler/parcels/field.h"

namespace citykiln::parcels {

/// Returns the sides and rear edges of pieces, the bisectors between pieces of different labels, and the shadows of
/// ends of obstacles, as far as labels
/// differ on their two sides. Lines are continued by kOverlap_m beyond their ends, so that they meet.
/// Cost: O(n k²) for n pieces of which k overlap in a place.
std::vector<std::pair<Vec2, Vec2>> lot_borders(const Field& field, int threads);

inline constexpr double kOverlap_m = 0.0625;

}  // namespace citykiln::parcels
