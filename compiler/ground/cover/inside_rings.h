// Point-in-polygon tests for many points against one polygon.
#pragma once

#include <vector>

#include "compiler/geometry/box.h"
#include "compiler/ground/recipe.h"

namespace citykiln::ground {

/// The edges of a polygon sorted into horizontal bands, so that a test looks at one band only.
struct BandedRings {
  struct Edge {
    Vec2 a, b;
  };
  Box2 box;  ///< Of all rings.
  double band_m = 1;
  std::vector<std::vector<Edge>> bands;  ///< From south to north.
};

/// O(edges + the bands they cross); about as many bands as edges.
BandedRings band_rings(const LandCoverPolygon& surface);

/// Returns whether the winding numbers of the rings add up to more than zero at p. A point on an edge may count to
/// either side. O(edges in the point's band).
bool is_inside(const BandedRings& rings, Vec2 p);

}  // namespace citykiln::ground
