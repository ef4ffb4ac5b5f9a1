// Terrains of tests, made by formulas.
#pragma once

#include <cmath>

#include "compiler/geometry/mathematics.h"
#include "compiler/invent/terrain.h"

namespace citykiln::invent {

enum class Ground { kFlat, kSlope, kHill, kRiver };

inline constexpr Ground kGrounds[] = {Ground::kFlat, Ground::kSlope, Ground::kHill, Ground::kRiver};

inline double made_height_m(Ground ground, double side_m, Vec2 p) {
  if (ground == Ground::kSlope) return 30 + p.x * 0.05;
  if (ground != Ground::kHill) return 30;
  const Vec2 from_top = p - Vec2{side_m * 0.25, side_m * 0.2};
  return 30 + 70 * exponential(-dot(from_top, from_top) / (0.12 * side_m * side_m));
}

/// A river from west to east, south of the middle, and a lake in the north-west.
inline void add_made_water(Terrain& terrain) {
  const double side_m = terrain.side_m;
  River river;
  for (int i = 0; i <= 60; ++i) {
    const double x = (i / 60.0 - 0.5) * side_m;
    river.axis.push_back({x, -0.13 * side_m + 40 * sine(x / 4)});
    river.width_m.push_back(22);
  }
  terrain.rivers.push_back(river);
  Ring lake;
  for (int i = 0; i < 24; ++i)
    lake.push_back({-0.3 * side_m + 60 * cosine(i * 15.0), 0.28 * side_m + 45 * sine(i * 15.0)});
  terrain.lakes.push_back({lake, {}});
}

inline Terrain made_ground(Ground ground, double side_m) {
  Terrain terrain;
  terrain.side_m = side_m * 1.1;
  terrain.cells = 64;
  terrain.sea_level_m = -100;
  const double step_m = terrain.side_m / terrain.cells;
  for (int row = 0; row <= terrain.cells; ++row)
    for (int column = 0; column <= terrain.cells; ++column) {
      const Vec2 p{column * step_m - terrain.side_m / 2, row * step_m - terrain.side_m / 2};
      terrain.heights_m.push_back(static_cast<float>(made_height_m(ground, side_m, p)));
    }
  if (ground == Ground::kRiver) add_made_water(terrain);
  return terrain;
}

}  // namespace citykiln::invent
