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
  Box2 box;  ///< The box of all rings.
  double band_m = 1;
  std::vector<std::vector<Edge>> bands;  ///< The edges in each band, from south to north.
};

/// Sorts the edges into bands of 32 m, or of 1/4096 of the polygon's height if that is more. O(edges + the bands that
/// they cross).
BandedRings band_rings(const LandCoverPolygon& surface);

/// True if the winding numbers of the rings add up to more than zero at p. A point on an edge may count as inside or
/// outside. O(edges in the point's band).
bool is_inside(const BandedRings& rings, Vec2 p);

}  // namespace citykiln::ground
