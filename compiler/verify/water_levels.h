// The levels of standing water by OSM id: what faces of that id must show.
#pragma once

#include <map>
#include <vector>

#include "compiler/scene/scene.h"

namespace citykiln::verify {

/// A water with at least one polygon that has a level. One riverbank relation may have standing parts and running ones:
/// an outline without a waterway in it is level, the others follow their waterway.
struct WaterParts {
  std::vector<const ground::LandCoverPolygon*> level;  ///< Of the chunk, which must outlive this.
  bool runs = false;                                   ///< Some polygon of the id has no level.
};

/// By the id of the water.
using WaterLevels = std::map<OsmId, WaterParts>;

/// O(polygons log polygons).
WaterLevels water_levels_of(const scene::Chunk& chunk);

/// Returns whether a face of the water stands at a place: everywhere if no part runs, else inside its level polygons.
/// O(corners of the polygons).
bool stands_at(const WaterParts& water, Vec2 p);

/// Returns how far a height is off the nearest of the water's levels.
double off_level_m(const WaterParts& water, double z_m);

}  // namespace citykiln::verify
