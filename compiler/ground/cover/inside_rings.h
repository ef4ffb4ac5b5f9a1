// Asks many times whether a point lies inside of one surface.
#pragma once

#include <vector>

#include "compiler/geometry/box.h"
#include "compiler/ground/recipe.h"

namespace citykiln::ground {

/// The borders of a surface in bands from west to east, so that a question asks only those of its own band.
struct BandedRings {
  struct Edge {
    Vec2 a, b;
  };
  Box2 box;  ///< Of all rings.
  double band_m = 1;
  std::vector<std::vector<Edge>> bands;  ///< From south to north.
};

/// Cost: linear in edges and in the bands that they cross; about as many bands as edges.
BandedRings band_rings(const LandCoverPolygon& surface);

/// True where the winding numbers of the rings add up to more than zero. A point on a border may count to either side.
/// O(edges of the point's band).
bool is_inside(const BandedRings& rings, Vec2 p);

}  // namespace citykiln::ground
