// Where the elements lie that diagnoses name.
#pragma once

#include <map>

#include "compiler/contract/report.h"
#include "compiler/map/plane.h"
#include "compiler/source/osm_data.h"

namespace citykiln::map {

/// Longitude and latitude by element.
using Places = std::map<OsmId, LonLat>;

/// Returns a place for every element that a diagnosis of the report names: of a node its own, of a way its middle node,
/// of an area the centre of its first ring's box, of another relation that of its first member with one.
/// Elements that the extract does not hold have none. Cost: linear in the extract.
Places places_of(const source::OsmData& osm, const Report& report);

/// Returns the places of all ways and areas, as above; for reports that are written when the extract is gone. O(n log
/// n).
Places places_of_ways_and_areas(const source::OsmData& osm);

}  // namespace citykiln::map
