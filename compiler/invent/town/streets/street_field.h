// The directions of streets: a field of two families of lines that cross square.
#pragma once

#include "compiler/invent/town/streets/street_graph.h"
#include "compiler/invent/town/town_plan.h"

namespace citykiln::invent {

/// Directions of streets on a raster. A direction is stored as the vector of twice its angle, so that a direction and
/// its opposite are the same and means are possible.
struct StreetField {
  TownRaster<Vec2> doubled;

  /// Returns the direction of a family at a place, as a unit vector: for family 0 along the field, for family 1 square
  /// to it, to the left. Places are metres from the middle of the town's square; outside the raster, the nearest value
  /// on its border applies.
  Vec2 direction(Vec2 p, int family) const;
};

/// Returns the field of a plan, sampled at steps of at most 32 m. It is the weighted sum of the grids of the centres,
/// rings about the first centre (not in villages), contour lines on slopes, and the directions of main roads within
/// some 250 m, turned a little by noise. Source: Chen, Esch, Wonka, Müller, Zhang, "Interactive Procedural Street
/// Modeling", SIGGRAPH 2008, section 5 (their basis fields).
StreetField street_field(const TownPlan& plan, const StreetGraph& main_roads);

}  // namespace citykiln::invent
