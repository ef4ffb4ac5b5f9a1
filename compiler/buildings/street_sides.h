// Which walls look at a street.
#pragma once

#include <span>
#include <vector>

#include "compiler/geometry/box_grid.h"
#include "compiler/map/features.h"

namespace citykiln::buildings {

/// The axes of all streets on the ground, by place. What one drives or walks along between houses; no rails, no paths.
struct Streets {
  struct Segment {
    Vec2 from, to;
    double half_width_m;
  };
  std::vector<Segment> segments;
  BoxGrid grid;
};

Streets index_streets(std::span<const map::Track> tracks);

/// For each edge of the outer ring whether a street lies before it: beyond the wall, no farther than a front garden and
/// an angle of 45 degrees. O(segments near).
std::vector<bool> street_sides(const Polygon& footprint, const Streets& streets);

}  // namespace citykiln::buildings
