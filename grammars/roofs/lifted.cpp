#include "grammars/roofs/base.h"

namespace citykiln::roofs {
namespace {

// The part of a facet between two distances from the eaves; the first and the last go on without end.
Ring band(const Facet& facet, const Section& section, std::size_t k, double span_m) {
  Plane inner = facet.plane, outer = facet.plane;
  inner.offset -= section.corners[k].x * span_m;
  outer = {outer.origin, outer.gradient * -1, section.corners[k + 1].x * span_m - outer.offset};
  Ring ring = k == 0 ? facet.ring : clipped(facet.ring, inner);
  return k + 2 == section.corners.size() ? ring : clipped(ring, outer);
}

}  // namespace

std::vector<Facet> lifted(const Base& base, const Section& section, double rise_m) {
  std::vector<Facet> facets;
  const auto bands = static_cast<std::uint32_t>(section.corners.size() - 1);
  for (const Facet& facet : base.facets)
    for (std::uint32_t k = 0; k < bands; ++k) {
      Ring ring = bands == 1 ? facet.ring : band(facet, section, k, base.span_m);
      if (ring.empty()) continue;
      const Vec2 low = section.corners[k], high = section.corners[k + 1];
      const double slope = rise_m * (high.y - low.y) / ((high.x - low.x) * base.span_m);
      const Plane plane = {facet.plane.origin, facet.plane.gradient * slope,
                           (facet.plane.offset - low.x * base.span_m) * slope + low.y * rise_m};
      facets.push_back({std::move(ring), plane, facet.sheet, facet.face * bands + k});
    }
  return facets;
}

}  // namespace citykiln::roofs
