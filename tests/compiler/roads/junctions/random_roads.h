// Random roads that meet in one place.
#pragma once

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "compiler/geometry/snap.h"
#include "tests/compiler/roads/made_road.h"

namespace citykiln::roads {

/// Returns roads with 1 to 12 arms, angles down to 0.01°, lengths from 1 mm and widths to 60 m; some have a second
/// node nearby.
inline std::vector<Road> random_roads(std::mt19937_64& chance) {
  using enum map::LandCoverClass;
  const auto unit = [&] { return static_cast<double>(chance() % 1000001) / 1e6; };
  std::vector<Road> roads;
  const int arms = 1 + static_cast<int>(chance() % 12);
  double angle = 0;
  Vec2 place{0, 0};
  for (int a = 0; a < arms; ++a) {
    angle += chance() % 3 == 0 ? 0.01 * std::numbers::pi / 180 : unit() * 2 * std::numbers::pi / arms;
    const double reach = 0.001 * std::pow(10.0, unit() * 5.3),
                 width = chance() % 10 == 0 ? 0.25 + unit() * 59.75 : 1 + unit() * 12;
    Polyline axis = {place};
    const int points = 1 + static_cast<int>(chance() % 3);
    for (int i = 1; i <= points; ++i) {
      const double bend = angle + (i - 1) * (unit() - 0.5) * 2;
      const Vec2 next = snapped(axis.back() + Vec2{std::cos(bend), std::sin(bend)} * (reach / points));
      if (next != axis.back()) axis.push_back(next);
    }
    if (axis.size() < 2) continue;
    if (chance() % 8 == 0) place = axis.back();
    const auto surface = chance() % 2 == 0 ? kPrimaryRoad : kResidentialRoad;
    roads.push_back(made_road(a + 1, std::move(axis), snapped(width) > 0 ? snapped(width) : 1, surface));
    if (chance() % 8 == 0) roads.back().section.lanes.front().way = map::LaneDirection::kForward;
    if (chance() % 16 == 0) roads.back().points.push_back({0, map::TrackPointKind::kMiniRoundabout, 0});
    if (chance() % 16 == 0) roads.back().points.push_back({1, map::TrackPointKind::kTurningCircle, 0});
  }
  return roads;
}

}  // namespace citykiln::roads
