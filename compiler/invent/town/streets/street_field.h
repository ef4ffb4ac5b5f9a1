// The directions of streets: a field of two families of lines that cross square.
#pragma once

#include "compiler/invent/town/streets/street_graph.h"
#include "compiler/invent/town/town_plan.h"

namespace citykiln::invent {

/// Directions as vectors of twice the angle, so that a direction and its opposite are the same and means are possible.
struct StreetField {
  TownRaster<Vec2> doubled;

  /// The direction of a family at a place, length 1: 0 along the field, 1 square to it.
  Vec2 direction(Vec2 p, int family) const;
};

/// Returns the field of a plan about its main roads: the grids of the centres, rings about old centres, contour lines
/// on slopes, and the directions of main roads near them, added with weights, and turned a little by noise. Source:
/// Chen, Esch, Wonka, Müller, Zhang, "Interactive Procedural Street Modeling", SIGGRAPH 2008, section 5: their basis
/// fields; sampled at 32 m.
StreetField street_field(const TownPlan& plan, const StreetGraph& main_roads);

}  // namespace citykiln::invent
