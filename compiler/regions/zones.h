// Zones: an extent that is too wide for one plane is cut into boxes of longitude and latitude, each with a plane of its
// own. Inside a zone tiles meet byte for byte; between zones the same place has equal coordinates on the Earth within
// kZoneAgreement_m.
#pragma once

#include <string>
#include <vector>

#include "compiler/source/osm_data.h"

namespace citykiln::regions {

/// The longest side of a zone.
inline constexpr double kZoneSide_m = 200000;

/// Two positions of the same place in the planes of two zones lie at most this far apart on the Earth: each is rounded
/// to map::kMapStep_m, along both axes, which is half a diagonal for each.
inline constexpr double kZoneAgreement_m = 0.0115;

struct Zone {
  int x = 0, y = 0;       ///< Columns from the west, rows from the south.
  source::LonLatBox box;  ///< In degrees; neighbours share a side.
};

/// "2_0".
std::string to_string(const Zone& zone);

/// Cuts an extent into equal boxes with sides of at most side_m, sorted by column, then row; one, if the extent is no
/// larger. The boxes cover the extent exactly.
std::vector<Zone> zones_of(const source::LonLatBox& extent, double side_m = kZoneSide_m);

/// The largest error of the scale within a zone whose plane has its origin in the middle, x²/2R² at its western and
/// eastern sides: 8 ppm for a zone of 50 km, 123 ppm for one of 200 km.
double scale_error(const Zone& zone);

}  // namespace citykiln::regions
