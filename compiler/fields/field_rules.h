// The usual size, form, borders and crops of fields at a place.
#pragma once

#include <cstdint>

#include "compiler/climate/climate_class.h"
#include "compiler/map/countries/country_group.h"
#include "compiler/map/land_cover_class.h"
#include "compiler/map/plane/plane.h"

namespace citykiln::fields {

/// The barrier between two fields.
enum class FieldBorder : std::uint8_t { kNone, kHedge, kWall };

/// The usual fields of a place.
struct FieldRule {
  double area_m2 = 0;       ///< > 0.
  double aspect = 1;        ///< Length by width, >= 1.
  FieldBorder border{};     ///< The barrier on borders.
  double border_share = 0;  ///< On this share of the borders, 0 … 1.
  bool is_grid = false;     ///< True where land was surveyed in squares of half a mile along the meridian.
};

/// Returns the first row of field_rules.inc whose ring contains a place, else the row of its country group. O(rings).
FieldRule field_rule_at(LonLat place);

/// The share of a crop that a draw picks, and where crops are drawn.
struct CropPlace {
  map::CountryGroup country{};
  climate::ClimateClass climate{};
};

/// Returns the crop of a field of farmland, by crops.inc.
/// @param draw  0 … 1, uniform.
map::LandCoverClass crop_at(const CropPlace& place, double draw);

}  // namespace citykiln::fields
