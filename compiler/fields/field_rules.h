// The usual size, form, borders and crops of fields at a place.
#pragma once

#include <cstdint>

#include "compiler/climate/climate_class.h"
#include "compiler/map/countries/country_group.h"
#include "compiler/map/land_cover_class.h"
#include "compiler/map/plane/plane.h"

namespace citykiln::fields {

/// The barrier on a border between two fields.
enum class FieldBorder : std::uint8_t { kNone, kHedge, kWall };

/// The usual fields of a place.
struct FieldRule {
  double area_m2 = 0;       ///< The usual area, > 0.
  double aspect = 1;        ///< The usual length divided by the width, >= 1.
  FieldBorder border{};     ///< The barrier on borders that have one.
  double border_share = 0;  ///< The share of borders with this barrier, 0 to 1.
  bool is_grid = false;     ///< True where land was surveyed in squares of half a mile.
};

/// Returns the rule of the first row of field_rules.inc whose ring contains a place, else that of
/// its country group. O(corners of rings).
FieldRule field_rule_at(LonLat place);

/// The country group and climate that decide which crops grow at a place.
struct CropConditions {
  map::CountryGroup country{};
  climate::ClimateClass climate{};
};

/// Returns the crop of a field of farmland. Its probability is the crop's share in crops.inc, in
/// the row of the climate if there is one, else in that of the country group.
/// @param draw  A uniform random number, from 0 to less than 1.
map::LandCoverClass crop_at(const CropConditions& place, double draw);

}  // namespace citykiln::fields
