// Reads from the tags of an element alone whether it can be an area or water, and how many plants grow on it.
#pragma once

#include <osmium/osm/tag.hpp>

namespace citykiln::regions {

/// True if an element may be a building or a part of one.
bool describes_building(const osmium::TagList& tags);

/// True if an element can become a land cover area or a building by map/land_cover/area_rules.inc, so that its outline
/// may surround a region without a vertex near it. True for more elements than become areas, never for fewer.
bool describes_area(const osmium::TagList& tags);

/// True if an element can become water: a waterway, a coastline, or an area of water.
bool describes_water(const osmium::TagList& tags);

/// True for natural=coastline.
bool is_coastline(const osmium::TagList& tags);

/// True for a relation of type multipolygon (it may have its tags on its outer ways), and for a boundary that
/// describes_area().
bool is_area_relation(const osmium::TagList& tags);

/// True for relations that a region needs with their members: areas, and buildings with their parts.
bool is_kept_with_members(const osmium::TagList& tags);

/// The number of plants per square metre of an area.
struct PlantDensity {
  double trees_per_m2 = 0;      ///< From plants/wood_defaults.inc.
  double plantings_per_m2 = 0;  ///< From plants/planting_defaults.inc.
};
/// Returns the plant density for the first row of map/land_cover/area_rules.inc that matches the tags; zeros if there
/// is none.
PlantDensity plant_density(const osmium::TagList& tags);

}  // namespace citykiln::regions
