// Addresses of buildings on the streets of a map.
#pragma once

#include "compiler/invent/invented_map.h"

namespace citykiln::invent {

/// Gives each building that is not an outbuilding the name of the nearest named street within 40 m, and a number: odd
/// on the street's left, even on its right, rising along it. O(buildings + street segments).
void address_buildings(InventedMap& map);

}  // namespace citykiln::invent
