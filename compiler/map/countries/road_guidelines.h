// Chooses the set of guidelines (national rules for lane widths) by which roads are built at a place.
#pragma once

#include <cstdint>

#include "compiler/map/plane/plane.h"

namespace citykiln::map {

enum class RoadGuidelines : std::uint8_t {
  kElsewhere,  ///< Widths of continental Europe.
  kNorthAmerica,
  kBritishIsles,
  kJapan,
};

/// Returns the guidelines by the country group of the place (country_group.h). The land border is accurate to 20 km; at
/// sea borders lie anywhere between the coasts. O(rings).
RoadGuidelines guidelines_at(LonLat place);

}  // namespace citykiln::map
