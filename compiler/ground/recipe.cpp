#include "compiler/ground/recipe.h"

#include <tuple>

namespace citykiln::ground {

bool covers(const LandCoverPolygon& a, const LandCoverPolygon& b) {
  const auto rank = [](const LandCoverPolygon& s) {
    return std::tuple(-priority_of(s), s.area_m2, s.id, s.surface, s.piece);
  };
  return rank(a) < rank(b);
}

Box2 box_of(const LandCoverPolygon& polygon) {
  Box2 box;
  for (const Ring& ring : polygon.rings)
    for (const Vec2 p : ring) box.grow(p);
  return box;
}

int winding_number(const LandCoverPolygon& polygon, Vec2 p) {
  int winding = 0;
  for (const Ring& ring : polygon.rings) winding += winding_number(ring, p);
  return winding;
}

}  // namespace citykiln::ground
