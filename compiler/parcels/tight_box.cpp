#include "compiler/parcels/tight_box.h"

#include <algorithm>
#include <limits>

namespace citykiln::parcels {

TightBox tight_box(const Ring& ring) {
  TightBox best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 u = unit(ring[(i + 1) % ring.size()] - ring[i]), v = left_of(u);
    if (u == Vec2{}) continue;
    Box2 box;
    for (const Vec2 p : ring) box.grow({dot(p, u), dot(p, v)});
    if (box.width() * box.height() >= least * (1 - 1e-9)) continue;
    least = box.width() * box.height();
    const Vec2 c = box.centre();
    best = {u * c.x + v * c.y, box.width() >= box.height() ? u : v, std::max(box.width(), box.height()),
            std::min(box.width(), box.height())};
  }
  return best;
}

}  // namespace citykiln::parcels
