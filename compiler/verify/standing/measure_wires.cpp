#include "compiler/verify/standing/measure_wires.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace citykiln::verify {
namespace {

constexpr double kWireStep_m = 2;

bool is_below_wires(const ground::LandCoverIndex& land_cover, Vec2 p) {
  const std::uint32_t top = ground::land_cover_at(land_cover, p);
  if (top == ground::kNoLandCover) return false;
  const map::LandCoverGroup group = map::values_of(land_cover.surfaces[top].surface).group;
  return group == map::LandCoverGroup::kRoad || group == map::LandCoverGroup::kRail;
}

// The least height of a span's wires above carriageways in the tile, and its place.
struct LowestWire {
  double above_m = std::numeric_limits<double>::infinity();
  Vec2 at;
};

LowestWire lowest_wire(const wires::WireSpan& span, const Box2& tile, const ground::LandCoverIndex& land_cover,
                       const GroundIndex& ground) {
  LowestWire lowest;
  for (const wires::Wire& wire : span.wires) {
    const int steps = static_cast<int>(std::ceil(distance(in_plan(wire.from), in_plan(wire.to)) / kWireStep_m));
    for (int i = 0; i <= steps; ++i) {
      const Vec3 place = wires::place_on(wire, static_cast<double>(i) / std::max(steps, 1));
      if (!tile.contains(in_plan(place)) || !is_below_wires(land_cover, in_plan(place))) continue;
      const std::vector<GroundHit> hits = ground_at(ground, in_plan(place));
      if (hits.empty() || place.z - hits.back().z_m >= lowest.above_m) continue;
      lowest = {place.z - hits.back().z_m, in_plan(place)};
    }
  }
  return lowest;
}

}  // namespace

WiresOverRoads measure_wires(const scene::Chunk& chunk, const Box2& tile, const ground::LandCoverIndex& land_cover,
                             const GroundIndex& ground, double least_m) {
  WiresOverRoads found;
  for (const wires::WireSpan& span : chunk.wire_spans) {
    const LowestWire lowest = lowest_wire(span, tile, land_cover, ground);
    if (!std::isfinite(lowest.above_m)) continue;
    if (found.spans++ == 0 || lowest.above_m < found.lowest_m)
      found.lowest_m = lowest.above_m, found.at = lowest.at, found.lowest = span.id.osm;
    if (lowest.above_m < least_m) ++found.low;
  }
  return found;
}

}  // namespace citykiln::verify
