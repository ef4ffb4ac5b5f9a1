#include "compiler/ground/recipe.h"

#include <tuple>

namespace citykiln::ground {

bool covers(const LandCoverPolygon& a, const LandCoverPolygon& b) {
  const auto rank = [](const LandCoverPolygon& s) {
    return std::tuple(-static_cast<int>(map::values_of(s.surface).priority), s.area_m2, s.id, s.surface, s.piece);
  };
  return rank(a) < rank(b);
}

}  // namespace citykiln::ground
