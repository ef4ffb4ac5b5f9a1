// What elements are by their tags alone: which ones the cut keeps whole, and how many plants grow on them.
#pragma once

#include <osmium/osm/tag.hpp>

namespace citykiln::regions {

/// Whether an element can become a land cover area or a building by map/area_rules.inc: its outline may lie around a
/// region without a vertex near it. Holds for more elements than become areas, never for fewer.
bool describes_area(const osmium::TagList& tags);

/// Whether an element can become water: a waterway, a coastline, or an area of water.
bool describes_water(const osmium::TagList& tags);

bool is_coastline(const osmium::TagList& tags);

/// A relation of type multipolygon, whose tags may be those of its outer ways, or a boundary that describes an area.
bool is_area_relation(const osmium::TagList& tags);

/// How many plants an area of these tags gets, by its first row in map/area_rules.inc.
struct PlantDensity {
  double trees_per_m2 = 0;      ///< plants/wood_defaults.inc.
  double plantings_per_m2 = 0;  ///< plants/planting_defaults.inc.
};
PlantDensity plant_density(const osmium::TagList& tags);

}  // namespace citykiln::regions
