#include "compiler/structures/deck_dimensions.h"

#include <algorithm>
#include <cassert>

namespace citykiln::structures {
namespace {

// Bays of 20 times the thickness are usual for slabs and beams; longer bays are built otherwise.
constexpr double kSlenderness = 20, kMinThickness_m = 0.4, kMaxThickness_m = 2;
// Thickness at the edge of a cantilever.
constexpr double kEdge_m = 0.45;
// Heights of parapets of roads (EN 1317: 0.8 to 1.2 m), ballast retainers, upstands under railings, railings (EN 1176).
constexpr double kRoadParapet_m = 1, kBallastWall_m = 0.35, kUpstand_m = 0.125, kRailing_m = 1.125;

}  // namespace

DeckDimensions deck_dimensions(const roads::Road& road, double bay_m) {
  assert(bay_m >= 0);
  DeckDimensions shape{.left_m = roads::left_m(road) + roads::raised_left_m(road),
                       .right_m = roads::right_m(road) + roads::raised_right_m(road),
                       .thickness_m = std::clamp(bay_m / kSlenderness, kMinThickness_m, kMaxThickness_m)};
  shape.edge_m = std::min(kEdge_m, shape.thickness_m);
  const map::LandCoverGroup group = map::values_of(road.surface).group;
  if (group == map::LandCoverGroup::kRoad) {
    shape.parapet_m = kRoadParapet_m;
    return shape;
  }
  shape.parapet_m = group == map::LandCoverGroup::kRail ? kBallastWall_m : kUpstand_m;
  shape.railing_m = kRailing_m;
  return shape;
}

double longest_bay_m(const Span& span) {
  assert(!span.axis.empty() && std::ranges::is_sorted(span.piers, {}, &Pier::at_m));
  const std::vector<double> along = roads::distances_along(span);
  double longest_m = 0, last_m = along.front();
  for (const Pier& pier : span.piers) {
    longest_m = std::max(longest_m, pier.at_m - last_m);
    last_m = pier.at_m;
  }
  return std::max(longest_m, along.back() - last_m);
}

}  // namespace citykiln::structures
