// The parameters of the country around towns, and of forest worlds.
#pragma once

namespace citykiln::invent {

struct CountrySettings {
  double wood_share = 0.25;        ///< The share of gentle land that is wood; steep land has more.
  double wood_size_m = 260;        ///< The size of a wood.
  double rock_slope = 0.9;         ///< The slope from which rock is bare.
  double heath_share = 0.06;       ///< The share of heath and scrub beside woods.
  bool has_farm_fields = true;     ///< False: meadows where there is no wood.
  double farm_field_ha = 1.6;      ///< The usual area of a field.
  double farm_field_slope = 0.14;  ///< The slope from which fields are meadows.
  double hedge_share = 0.35;       ///< The share of borders of fields that have a hedge.
  double orchard_share = 0.06;     ///< The share of fields that are orchards.
  double tree_row_share = 0.2;     ///< The share of tracks with a row of trees.
  double tracks_per_km2 = 2;       ///< Tracks for each square kilometre of the map.
};

}  // namespace citykiln::invent
