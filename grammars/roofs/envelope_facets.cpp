#include <algorithm>

#include "grammars/roofs/inset_facets.h"

namespace citykiln::roofs {
namespace {

Ring lowest_part(std::span<const Vec2> ring, std::span<const Plane> planes, std::size_t own) {
  Ring part(ring.begin(), ring.end());
  // neighbours first, since they remove most
  const std::size_t n = planes.size();
  for (std::size_t step = 1; step < n && !part.empty(); ++step) {
    const std::size_t other = step % 2 ? (own + (step + 1) / 2) % n : (own + n - step / 2) % n;
    part = clipped(part, combined(1, planes[other], -1, planes[own]));
  }
  return part;
}

}  // namespace

InsetFacets envelope_facets(std::span<const Vec2> convex_ring, std::span<const Plane> planes) {
  InsetFacets inset;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    Ring part = lowest_part(convex_ring, planes, i);
    if (part.empty()) continue;
    for (const Vec2 p : part) inset.span_m = std::max(inset.span_m, planes[i].at(p));
    inset.facets.push_back({.ring = std::move(part), .plane = planes[i], .face = static_cast<std::uint32_t>(i)});
  }
  return inset;
}

double span_over(std::span<const Vec2> convex_ring, std::span<const Plane> planes) {
  return envelope_facets(convex_ring, planes).span_m;
}

}  // namespace citykiln::roofs
