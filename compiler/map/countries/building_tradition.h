// The building tradition of a place: which style of old blocks of flats, built from about 1850 to 1918, it has.
#pragma once

#include <cstdint>

#include "compiler/map/plane/plane.h"

namespace citykiln::map {

/// A regional style of blocks of flats from about 1850 to 1918, in part of one or more country groups.
enum class BuildingTradition : std::uint8_t {
  kOther,        ///< The practice of the country group.
  kFrance,       ///< France and Monaco.
  kBelgium,      ///< Belgium, which builds narrow houses besides.
  kGermany,      ///< Germany, Austria, the Czech lands, western Poland, Slovakia, Hungary.
  kNetherlands,  ///< The Netherlands and the plain of north-west Germany, which build of brick.
  kCount
};

/// Returns the tradition by the rings of building_traditions.inc; kOther outside of all rings. Land borders are
/// accurate to about 30 km; at sea they lie anywhere between the coasts. O(corners of rings).
BuildingTradition building_tradition_at(LonLat place);

}  // namespace citykiln::map
