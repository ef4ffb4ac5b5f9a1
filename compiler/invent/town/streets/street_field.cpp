#include "compiler/invent/town/streets/street_field.h"

#include <algorithm>
#include <cmath>

#include "compiler/geometry/mathematics.h"
#include "compiler/geometry/trig.h"
#include "compiler/invent/town/smooth_noise.h"

namespace citykiln::invent {
namespace {

constexpr double kFieldStep_m = 32;
/// Main roads turn streets up to about this distance.
constexpr double kRoadInfluence_m = 130;

Vec2 doubled_of(Vec2 direction) {
  return {direction.x * direction.x - direction.y * direction.y, 2 * direction.x * direction.y};
}

double bell(double distance_m, double width_m) {
  const double t = distance_m / width_m;
  return t > 4 ? 0 : exponential(-t * t);
}

// the sum of the directions of main roads, by their distance
TownRaster<Vec2> along_roads(const TownPlan& plan, const StreetGraph& roads) {
  TownRaster<Vec2> sum(plan.settings.side_m, kFieldStep_m);
  for (const StreetSegment& s : roads.segments()) {
    if (s.is_removed) continue;
    const Vec2 a = roads.position(s.a), b = roads.position(s.b), middle = (a + b) * 0.5;
    const Vec2 doubled = doubled_of(unit(b - a)) * (distance(a, b) / 60);
    const double far_m = 2 * kRoadInfluence_m;
    for (int row = sum.row(middle.y - far_m); row <= sum.row(middle.y + far_m); ++row)
      for (int column = sum.column(middle.x - far_m); column <= sum.column(middle.x + far_m); ++column) {
        Vec2& value = sum.values[sum.index(column, row)];
        value = value + doubled * bell(distance(sum.place(column, row), middle), kRoadInfluence_m);
      }
  }
  return sum;
}

Vec2 centre_field(const TownPlan& plan, Vec2 p) {
  Vec2 sum{};
  for (std::size_t i = 0; i < plan.centres.size(); ++i) {
    const Centre& centre = plan.centres[i];
    const double d = distance(centre.position, p);
    sum = sum + doubled_of(centre.grid) * (0.08 * bell(d, 2400) + bell(d, 700));
    // old towns have rings and rays about their middle
    const bool is_radial = i == 0 && plan.settings.kind != TownKind::kVillage;
    if (is_radial && d > 1) sum = sum + doubled_of((p - centre.position) * (1 / d)) * (1.4 * bell(d, 420));
  }
  return sum;
}

Vec2 contour_field(const TownPlan& plan, Vec2 p) {
  const Vec2 slope = plan.terrain->gradient(p);
  const double steepness = length(slope);
  return steepness < 1e-6 ? Vec2{} : doubled_of(left_of(unit(slope))) * std::min(2.5, steepness * steepness * 400);
}

// turns a doubled direction by up to 16° of the plain angle
Vec2 turned_by_noise(const TownPlan& plan, Vec2 doubled, Vec2 p) {
  const Vec2 turn = direction_of(smooth_noise(plan.settings.seed ^ 0x5eed, p, 380) * 0.09);
  return {doubled.x * turn.x - doubled.y * turn.y, doubled.x * turn.y + doubled.y * turn.x};
}

}  // namespace

Vec2 StreetField::direction(Vec2 p, int family) const {
  const Vec2 d = unit(doubled.at(p));
  // the half angle, by half-angle formulas
  const double x = std::sqrt(std::max(0.0, (1 + d.x) / 2)), y = std::sqrt(std::max(0.0, (1 - d.x) / 2));
  const Vec2 along = unit(Vec2{x, d.y < 0 ? -y : y});
  return family == 0 ? along : left_of(along);
}

StreetField street_field(const TownPlan& plan, const StreetGraph& main_roads) {
  const TownRaster<Vec2> roads = along_roads(plan, main_roads);
  StreetField field{TownRaster<Vec2>(plan.settings.side_m, kFieldStep_m)};
  for (int row = 0; row <= field.doubled.cells; ++row)
    for (int column = 0; column <= field.doubled.cells; ++column) {
      const Vec2 p = field.doubled.place(column, row);
      const std::size_t i = field.doubled.index(column, row);
      const Vec2 sum = centre_field(plan, p) + contour_field(plan, p) + roads.values[i] * 0.55 + Vec2{1e-6, 0};
      field.doubled.values[i] = unit(turned_by_noise(plan, sum, p));
    }
  return field;
}

}  // namespace citykiln::invent
