// Divides an extent that is too wide for one plane (map projection) into zones: boxes of longitude and latitude, each
// with a plane of its own. Inside a zone tiles meet byte for byte. The coordinates that two zones give a place on their
// common side are at most kZoneAgreement_m apart on the Earth.
#pragma once

#include <string>
#include <vector>

#include "compiler/source/osm_data.h"

namespace citykiln::regions {

/// The longest side of a zone, in metres.
inline constexpr double kZoneSide_m = 200000;

/// The largest distance on the Earth between the positions of one place in the planes of two zones, in metres. Each
/// zone rounds x and y to map::kMapStep_m, which moves a place by up to half a diagonal of the grid.
inline constexpr double kZoneAgreement_m = 0.0115;

/// One box of the extent.
struct Zone {
  int x = 0, y = 0;       ///< Column from the west, row from the south.
  source::LonLatBox box;  ///< In degrees. Neighbouring boxes share a side.
};

/// Returns column and row as a text, such as "2_0".
std::string to_string(const Zone& zone);

/// Cuts an extent into equal boxes with sides of at most side_m metres, sorted by column, then row. A smaller extent is
/// one box. The boxes cover the extent exactly.
std::vector<Zone> zones_of(const source::LonLatBox& extent, double side_m = kZoneSide_m);

/// Returns the largest relative error of the scale in a zone whose plane has its origin in the middle: x²/2R² at the
/// western and eastern sides. It is 8 ppm for a zone of 50 km and 123 ppm for one of 200 km.
double scale_error(const Zone& zone);

}  // namespace citykiln::regions
