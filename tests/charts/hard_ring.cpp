#include "compiler/geometry/snap.h"
#include "tests/charts/hard_cases.h"

namespace citykiln::charts {
namespace {

Vec2 in_direction(double angle) { return {std::cos(angle), std::sin(angle)}; }

}  // namespace

Ring hard_ring(HardDraw& draw, Vec2 middle) {
  Ring ring;
  const int corners = draw.whole(4, 12);
  for (int i = 0; i < corners; ++i) {
    const Vec2 p =
        snapped(middle + in_direction((i + draw.between(0.1, 0.9)) * 6.283185307 / corners) * draw.between(6, 20));
    ring.push_back(p);
    const int kind = draw.whole(0, 9);
    if (kind == 0) ring.push_back(p);
    if (kind == 1)
      ring.push_back(snapped(p + unit(p - middle) * draw.between(1, 9))), ring.push_back(p + Vec2{kQuantum_m, 0});
    if (kind == 2) ring.push_back(snapped(p + left_of(p - middle) * 0x1p-9));
  }
  return ring;
}

}  // namespace citykiln::charts
