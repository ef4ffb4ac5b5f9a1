// Footprints for roof tests.
#pragma once

#include <string>
#include <vector>

#include "compiler/geometry/polygon.h"
#include "compiler/geometry/snap.h"
#include "compiler/geometry/trig.h"

namespace citykiln::roofs {

struct NamedFootprint {
  std::string name;
  Polygon polygon;
};

/// A circle on the grid of the plane.
inline Ring circle(Vec2 centre, double radius_m, int corners) {
  Ring ring;
  for (int i = 0; i < corners; ++i)
    ring.push_back(snapped_to(0x1p-7, centre + direction_of(static_cast<double>(i) / corners) * radius_m));
  return ring;
}

inline Ring box(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }
inline Ring hole(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x0, y1}, {x1, y1}, {x1, y0}}; }

/// Returns eleven footprints, from a rectangle to degenerate outlines.
inline std::vector<NamedFootprint> made_footprints() {
  return {
      {"rectangle", {box(0, 0, 16, 10), {}}},
      {"L", {{{0, 0}, {20, 0}, {20, 8}, {8, 8}, {8, 18}, {0, 18}}, {}}},
      {"T", {{{0, 12}, {8, 12}, {8, 0}, {16, 0}, {16, 12}, {24, 12}, {24, 20}, {0, 20}}, {}}},
      {"U", {{{0, 0}, {24, 0}, {24, 18}, {16, 18}, {16, 8}, {8, 8}, {8, 18}, {0, 18}}, {}}},
      {"cross",
       {{{8, 0}, {16, 0}, {16, 8}, {24, 8}, {24, 16}, {16, 16}, {16, 24}, {8, 24}, {8, 16}, {0, 16}, {0, 8}, {8, 8}},
        {}}},
      {"courtyard", {box(0, 0, 26, 22), {hole(8, 8, 18, 14)}}},
      {"two courtyards", {box(0, 0, 40, 22), {hole(8, 7, 17, 15), hole(24, 7, 32, 15)}}},
      {"circle", {circle({8, 8}, 8, 64), {}}},
      {"sliver", {box(0, 0, 30, 0.25), {}}},
      // two corners 8 mm apart, a wall with a bend of 8 mm, a notch like a needle
      {"near-degenerate",
       {{{0, 0}, {8, -0x1p-7}, {16, 0}, {16, 0x1p-7}, {16, 10}, {9, 10}, {9 - 0x1p-7, 2}, {9 - 0x1p-6, 10}, {0, 10}},
        {}}},
      // two squares that share a corner, and a hole that touches a corner
      {"self-touching",
       {{{0, 0}, {10, 0}, {10, 10}, {22, 10}, {22, 22}, {10, 22}, {10, 10}, {0, 10}},
        {{{10, 10}, {14, 16}, {16, 14}}}}},
  };
}

}  // namespace citykiln::roofs
