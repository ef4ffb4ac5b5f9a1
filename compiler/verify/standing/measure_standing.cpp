#include "compiler/verify/standing/measure_standing.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace citykiln::verify {
namespace {

// Walls lower than this have no storeys.
constexpr double kLeastWall_m = 1;

struct GroundAbout {
  double lowest_m = std::numeric_limits<double>::infinity(), highest_m = -lowest_m;
};

bool grow(GroundAbout& about, const GroundIndex& ground, Vec2 p) {
  const std::vector<GroundHit> hits = ground_at(ground, p);
  if (hits.empty()) return false;
  about.lowest_m = std::min(about.lowest_m, hits.front().z_m);
  about.highest_m = std::max(about.highest_m, hits.back().z_m);
  return true;
}

// The ground along the outer walls; nothing if it is unknown at a place.
std::optional<GroundAbout> ground_about(const Ring& ring, const GroundIndex& ground) {
  GroundAbout about;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
    if (!grow(about, ground, a) || !grow(about, ground, (a + b) * 0.5)) return std::nullopt;
  }
  return about;
}

// How far the building is off the ground; 0 if it stands on it.
double off_ground_m(const buildings::Building& building, const GroundAbout& about, double error_m) {
  if (building.top_m < about.lowest_m - error_m) return building.top_m - about.lowest_m;
  const double storey_m = buildings::storey_m(building);
  const double above_m = building.floor_m - about.highest_m;
  return storey_m >= kLeastWall_m && above_m > std::max(kMostFloorRise_m, storey_m) + error_m ? above_m : 0;
}

}  // namespace

FloorMeasure measure_standing(const scene::Chunk& chunk, const GroundIndex& ground, double error_m) {
  FloorMeasure standing;
  for (const buildings::Building& building : chunk.buildings) {
    if (!building.stands_on_ground || building.footprint.outer.empty()) continue;
    const auto about = ground_about(building.footprint.outer, ground);
    if (!about) continue;
    ++standing.buildings;
    const double off_m = off_ground_m(building, *about, error_m);
    if (off_m != 0) standing.off.push_back({building.id.osm, off_m, building.footprint.outer.front()});
  }
  return standing;
}

}  // namespace citykiln::verify
