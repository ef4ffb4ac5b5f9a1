#include "compiler/verify/measure_lakes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "compiler/contract/tolerance.h"

namespace citykiln::verify {
namespace {

/// The levels of the waters with one id, and the largest deviation of their faces.
struct Water {
  std::vector<double> levels_m;
  double deviation_m = -1;
  Vec2 at{};

  void add(Vec3 corner);
};

double deviation_m(const std::vector<double>& levels_m, double z_m) {
  double least_m = 1e9;
  for (const double level_m : levels_m) least_m = std::min(least_m, std::abs(z_m - level_m));
  return least_m;
}

void Water::add(Vec3 corner) {
  const double off_m = verify::deviation_m(levels_m, corner.z);
  if (off_m > deviation_m) deviation_m = off_m, at = in_plan(corner);
}

}  // namespace

Lakes combined(const Lakes& a, const Lakes& b) {
  const Lakes& worst = b.largest_m > a.largest_m ? b : a;
  return {a.waters + b.waters, a.not_level + b.not_level, worst.largest_m, worst.worst, worst.at};
}

Lakes measure_lakes(const scene::Chunk& chunk, const GroundIndex& ground) {
  std::map<OsmId, Water> waters;
  for (const ground::LandCoverPolygon& surface : chunk.surfaces)
    if (surface.level_m) waters[surface.id.osm].levels_m.push_back(*surface.level_m);
  for (const GroundFace& face : ground.faces) {
    const auto water = waters.find(face.feature);
    if (water == waters.end()) continue;
    for (const Vec3& corner : face.corners) water->second.add(corner);
  }
  Lakes lakes;
  for (const auto& [id, water] : waters) {
    if (water.deviation_m < 0) continue;
    ++lakes.waters;
    lakes.not_level += water.deviation_m > kQuantum_m;
    if (water.deviation_m <= lakes.largest_m) continue;
    lakes.largest_m = water.deviation_m, lakes.worst = id, lakes.at = water.at;
  }
  return lakes;
}

}  // namespace citykiln::verify
