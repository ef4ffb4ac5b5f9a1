#include "compiler/verify/heights/water_levels.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace citykiln::verify {

WaterLevels water_levels_of(const scene::Chunk& chunk) {
  WaterLevels waters;
  for (const ground::LandCoverPolygon& surface : chunk.surfaces)
    if (surface.level_m) waters[surface.id.osm].level.push_back(&surface);
  for (const ground::LandCoverPolygon& surface : chunk.surfaces)
    if (const auto water = waters.find(surface.id.osm); water != waters.end() && !surface.level_m)
      water->second.runs = true;
  return waters;
}

bool stands_at(const WaterParts& water, Vec2 p) {
  const auto contains = [&](const ground::LandCoverPolygon* part) { return ground::winding_number(*part, p) > 0; };
  return !water.runs || std::ranges::any_of(water.level, contains);
}

double off_level_m(const WaterParts& water, double z_m) {
  double least_m = std::numeric_limits<double>::infinity();
  for (const ground::LandCoverPolygon* part : water.level) least_m = std::min(least_m, std::abs(z_m - *part->level_m));
  return least_m;
}

}  // namespace citykiln::verify
