#include <utility>

#include "grammars/roofs/inset_facets.h"

namespace citykiln::roofs {
namespace {

Plane turned_over(const Plane& plane) { return {plane.origin, plane.gradient * -1, -plane.offset}; }

// The parts of a facet between two distances from the eaves; the first and the last band go on without end.
std::vector<Ring> band(const Facet& facet, const Section& section, std::size_t k, double span_m) {
  Plane inner = facet.plane, outer = facet.plane;
  inner.offset -= section.corners[k].x * span_m;
  outer.offset -= section.corners[k + 1].x * span_m;
  const std::vector<Ring> within = k == 0 ? std::vector<Ring>{facet.ring} : clipped_pieces(facet.ring, inner);
  if (k + 2 == section.corners.size()) return within;
  std::vector<Ring> between;
  for (const Ring& ring : within)
    for (Ring& piece : clipped_pieces(ring, turned_over(outer))) between.push_back(std::move(piece));
  return between;
}

// Heights over one band.
Plane lifted(const Plane& inward, Vec2 low, Vec2 high, double span_m, double rise_m) {
  const double slope = rise_m * (high.y - low.y) / ((high.x - low.x) * span_m);
  return {inward.origin, inward.gradient * slope, (inward.offset - low.x * span_m) * slope + low.y * rise_m};
}

}  // namespace

std::vector<Facet> lifted(const InsetFacets& base, const Section& section, double rise_m) {
  std::vector<Facet> facets;
  const auto bands = static_cast<std::uint32_t>(section.corners.size() - 1);
  for (const Facet& facet : base.facets)
    for (std::uint32_t k = 0; k < bands; ++k) {
      const Plane plane = lifted(facet.plane, section.corners[k], section.corners[k + 1], base.span_m, rise_m);
      for (Ring& ring : band(facet, section, k, base.span_m))
        facets.push_back({std::move(ring), plane, facet.sheet, facet.face * bands + k});
    }
  return facets;
}

}  // namespace citykiln::roofs
