// Land that the country cannot have: towns, roads, water, and what is already covered.
#pragma once

#include <span>
#include <vector>

#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/polygon.h"
#include "compiler/invent/invented_map.h"
#include "compiler/invent/tags.h"
#include "compiler/invent/terrain.h"

namespace citykiln::invent {

/// Polygons, and rights-of-way along lines. index() must be called after the last addition.
class TakenLand {
 public:
  void add(const Polygon& polygon);
  void add(const Polyline& axis, double half_width_m);
  void index();

  /// Returns the distance to the nearest taken land, negative or zero inside; at most `within_m`. O(1).
  double distance_m(Vec2 p, double within_m) const;
  /// Returns the taken land near a box as polygons. Rights-of-way give a quadrangle for each segment.
  std::vector<Polygon> polygons_near(const Box2& box) const;

 private:
  struct Piece {
    Polygon polygon;  ///< Empty for a segment.
    Vec2 a, b;
    double half_width_m = 0;
  };
  std::vector<Piece> pieces_;
  std::vector<Box2> boxes_;
  BoxGrid grid_;
};

/// Returns half the width of the right-of-way that a line of the map takes; 0 for lines that take none.
double half_right_of_way_m(const InventedLine& line);

/// Returns the rights-of-way of roads and railways of a map; with_areas also mapped land (landuse, leisure, amenity,
/// building, natural, tourism, aeroway), rivers and the sea. Call index() before use.
TakenLand taken_land_of(const InventedMap& map, const Terrain& terrain, bool with_areas);

}  // namespace citykiln::invent
