// Lot borders: the lines along which a field's labels differ.
#pragma once

#include <utility>
#include <vector>

#include "compiler/parcels/field.h"

namespace citykiln::parcels {

/// Returns the lines on whose two sides labels differ: sides and rear edges of pieces, bisectors between pieces, and
/// shadows behind the ends of obstacles. Lines are continued by kOverlap_m beyond their ends, so that they meet.
/// Cost: O(n k²) for n pieces of which k overlap in a place.
std::vector<std::pair<Vec2, Vec2>> lot_borders(const Field& field, int threads);

/// How far borders go on beyond their ends.
inline constexpr double kOverlap_m = 0.0625;

}  // namespace citykiln::parcels
