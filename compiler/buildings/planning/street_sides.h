// Finds the walls that face a street.
#pragma once

#include <span>
#include <vector>

#include "compiler/geometry/box_grid.h"
#include "compiler/map/features.h"

namespace citykiln::buildings {

/// The axis segments of all streets on the ground, with a spatial index. Rails and paths are not streets.
struct Streets {
  struct Segment {
    Vec2 from, to;
    double half_width_m;
  };
  std::vector<Segment> segments;
  BoxGrid grid;
};

/// Returns the streets of a map.
Streets index_streets(std::span<const map::Track> tracks);

/// Returns true for each edge of the outer ring, at least 1.5 m long, that faces a street: a kerb lies within 14 m
/// (pavement and front garden) and within 45 degrees of the edge's outward normal. O(segments near).
std::vector<bool> street_sides(const Polygon& footprint, const Streets& streets);

}  // namespace citykiln::buildings
