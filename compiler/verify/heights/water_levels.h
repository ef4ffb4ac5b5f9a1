// The levels of standing water by OSM id, which the faces of that id must have.
#pragma once

#include <map>
#include <vector>

#include "compiler/scene/scene.h"

namespace citykiln::verify {

/// The polygons of one OSM element with standing water. A riverbank relation can have standing and running parts: an
/// outline without a waterway in it is level, other outlines follow their waterway.
struct WaterParts {
  std::vector<const ground::LandCoverPolygon*> level;  ///< Polygons with a level; the chunk must outlive this.
  bool runs = false;                                   ///< True if a polygon of the id has no level.
};

/// Waters by id.
using WaterLevels = std::map<OsmId, WaterParts>;

/// Returns the waters of a chunk that have a level. O(polygons log polygons).
WaterLevels water_levels_of(const scene::Chunk& chunk);

/// True if a face of the water must be level at a place: everywhere if no part runs, else inside its level polygons.
/// O(corners of the polygons).
bool stands_at(const WaterParts& water, Vec2 p);

/// Returns the distance of a height from the nearest of the water's levels, in metres.
double off_level_m(const WaterParts& water, double z_m);

}  // namespace citykiln::verify
