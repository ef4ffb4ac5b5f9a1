#include <cassert>
#include <utility>

#include "grammars/roofs/inset_facets.h"

namespace citykiln::roofs {
namespace {

Plane negated(const Plane& plane) { return {plane.origin, plane.gradient * -1, -plane.offset}; }

// The parts of a facet in the band between corners k and k + 1. The first and the last band are unlimited outward.
std::vector<Ring> band(const Facet& facet, const Section& section, std::size_t k, double span_m) {
  Plane inner = facet.plane, outer = facet.plane;
  inner.offset -= section.corners[k].x * span_m;
  outer.offset -= section.corners[k + 1].x * span_m;
  const std::vector<Ring> within = k == 0 ? std::vector<Ring>{facet.ring} : clipped_pieces(facet.ring, inner);
  if (k + 2 == section.corners.size()) return within;
  std::vector<Ring> between;
  for (const Ring& ring : within)
    for (Ring& piece : clipped_pieces(ring, negated(outer))) between.push_back(std::move(piece));
  return between;
}

// The plane of heights over one band.
Plane lifted(const Plane& inward, Vec2 low, Vec2 high, double span_m, double rise_m) {
  const double slope = rise_m * (high.y - low.y) / ((high.x - low.x) * span_m);
  return {inward.origin, inward.gradient * slope, (inward.offset - low.x * span_m) * slope + low.y * rise_m};
}

}  // namespace

std::vector<Facet> lift_section(const InsetFacets& inset, const Section& section, double rise_m) {
  assert(section.corners.size() >= 2 && inset.span_m > 0);
  std::vector<Facet> facets;
  const auto bands = static_cast<std::uint32_t>(section.corners.size() - 1);
  for (const Facet& facet : inset.facets)
    for (std::uint32_t k = 0; k < bands; ++k) {
      const Plane plane = lifted(facet.plane, section.corners[k], section.corners[k + 1], inset.span_m, rise_m);
      for (Ring& ring : band(facet, section, k, inset.span_m))
        facets.push_back(
            {.ring = std::move(ring), .plane = plane, .surface = facet.surface, .face = facet.face * bands + k});
    }
  return facets;
}

}  // namespace citykiln::roofs
