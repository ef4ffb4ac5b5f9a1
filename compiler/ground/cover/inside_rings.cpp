#include "compiler/ground/cover/inside_rings.h"

#include <algorithm>
#include <cmath>

namespace citykiln::ground {
namespace {

// The height of a band: the length of a few edges of a river's bank.
constexpr double kBand_m = 32;
constexpr std::size_t kMaxBands = 4096;

std::size_t band_at(const BandedRings& rings, double y) {
  const double band = std::floor((y - rings.box.min.y) / rings.band_m);
  return static_cast<std::size_t>(std::clamp(band, 0.0, static_cast<double>(rings.bands.size() - 1)));
}

void add_ring_edge(BandedRings& rings, Vec2 a, Vec2 b) {
  const std::size_t last = band_at(rings, std::max(a.y, b.y));
  for (std::size_t i = band_at(rings, std::min(a.y, b.y)); i <= last; ++i) rings.bands[i].push_back({a, b});
}

}  // namespace

BandedRings band_rings(const LandCoverPolygon& surface) {
  BandedRings rings;
  rings.box = box_of(surface);
  if (rings.box.is_empty()) return rings;
  const double count = std::clamp(std::ceil(rings.box.height() / kBand_m), 1.0, static_cast<double>(kMaxBands));
  rings.band_m = std::max(rings.box.height() / count, kBand_m);
  rings.bands.resize(static_cast<std::size_t>(count));
  for (const Ring& ring : surface.rings)
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) add_ring_edge(rings, ring[j], ring[i]);
  return rings;
}

bool is_inside(const BandedRings& rings, Vec2 p) {
  if (!rings.box.contains(p)) return false;
  int winding = 0;
  for (const auto& [a, b] : rings.bands[band_at(rings, p.y)]) {
    if ((a.y <= p.y) == (b.y <= p.y)) continue;
    const double side = cross(b - a, p - a);
    if (a.y <= p.y && side > 0) ++winding;
    if (b.y <= p.y && side < 0) --winding;
  }
  return winding > 0;
}

}  // namespace citykiln::ground
