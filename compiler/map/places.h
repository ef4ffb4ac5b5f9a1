// Places of map elements, for diagnoses that name them.
#pragma once

#include <map>

#include "compiler/contract/findings/report.h"
#include "compiler/geometry/box.h"
#include "compiler/map/plane/plane.h"
#include "compiler/source/osm_data.h"

namespace citykiln::map {

/// Longitude and latitude by element.
using Places = std::map<OsmId, LonLat>;

/// Returns a place for the object of each diagnosis of the report, not for Diagnosis::other: a node's own place, a
/// way's middle node, the centre of the box of an area's first ring; for another relation, the place of its first
/// member that has one. Elements that are not in the extract are left out. O(d log n), d: diagnoses, n: elements.
Places places_of(const source::OsmData& osm, const Report& report);

/// Returns the box of an element in the plane: of its node, its way's nodes, or its relation's nodes and ways. Empty
/// for an element without nodes in the extract. O(log n + nodes).
Box2 box_of_element(const source::OsmData& osm, const Plane& plane, OsmId object);

/// Removes the diagnoses of elements whose box lies outside of the extent, and kOutsideBounds: what lies outside was
/// not asked for; the ledger counts it. Stray nodes are outside by nature and stay.
void remove_diagnoses_outside(const source::OsmData& osm, const Plane& plane, const Box2& extent, Report& report);

/// Returns the places of all ways and areas, for reports that are written after the extract has been freed. O(n log n).
Places places_of_ways_and_areas(const source::OsmData& osm);

}  // namespace citykiln::map
