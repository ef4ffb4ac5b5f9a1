// A graded road over uneven hills.
#pragma once

#include <utility>

#include "compiler/ground/grading/graded_terrain.h"

namespace citykiln::ground {

/// Returns a terrain of 128 m square about the origin, graded for a road that bends in the middle and rises by 5 m.
inline GradedTerrain road_over_hills(decltype(roads::Road::section) section) {
  map::Heightfield field{{-128, -128}, {32, 32}, 9, 9, {}, 0};
  for (int i = 0; i < 81; ++i) field.heights.push_back((i * 7919) % 640);
  roads::Road road;
  road.id = {{OsmType::kWay, 1}, 0};
  road.axis = {{-60, -20}, {0, 10}, {60, 0}};
  road.surface = map::LandCoverClass::kResidentialRoad;
  road.section = std::move(section);
  road.profile = {{0, 4, 0}, {130, 9, 0.0625}};
  return grade_terrain(std::move(field), {std::vector{road}, {}, {}, {{-64, -64}, {64, 64}}});
}

}  // namespace citykiln::ground
