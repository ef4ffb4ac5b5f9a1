#include "compiler/invent/town/town_plan.h"

#include <algorithm>

#include "compiler/geometry/segment.h"
#include "compiler/geometry/trig.h"
#include "compiler/invent/town/draws.h"
#include "compiler/invent/town/railway.h"
#include "compiler/invent/town/smooth_noise.h"

namespace citykiln::invent {
namespace {

// marks the points of a row that lie in a polygon
void fill_row(TownRaster<double>& wet, const Polygon& polygon, int row) {
  const double y = wet.place(0, row).y;
  std::vector<double> crossings;
  for (const Ring* ring : rings_of(polygon))
    for (std::size_t i = 0, j = ring->size() - 1; i < ring->size(); j = i++) {
      const Vec2 a = (*ring)[j], b = (*ring)[i];
      if ((a.y <= y) != (b.y <= y)) crossings.push_back(a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y)));
    }
  std::ranges::sort(crossings);
  const double west = -wet.side_m / 2;
  for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
    const int first = std::max(0, static_cast<int>(std::ceil((crossings[k] - west) / wet.step_m)));
    const int last = std::min<int>(wet.cells, static_cast<int>(std::floor((crossings[k + 1] - west) / wet.step_m)));
    for (int column = first; column <= last; ++column) wet.values[wet.index(column, row)] = 0;
  }
}

void fill_polygon(TownRaster<double>& wet, const Polygon& polygon) {
  const Box2 box = box_of(polygon.outer);
  if (box.is_empty()) return;
  for (int row = wet.row(box.min.y); row <= wet.row(box.max.y); ++row) fill_row(wet, polygon, row);
}

// marks the points within half a width of a piece of a river
void fill_reach(TownRaster<double>& wet, Vec2 a, Vec2 b, double half_m) {
  Box2 box;
  box.grow(a);
  box.grow(b);
  box = box.widened(half_m);
  if (box.max.x < -wet.side_m / 2 || box.min.x > wet.side_m / 2) return;
  for (int row = wet.row(box.min.y); row <= wet.row(box.max.y); ++row)
    for (int column = wet.column(box.min.x); column <= wet.column(box.max.x); ++column)
      if (distance_to_segment(a, b, wet.place(column, row)) <= half_m) wet.values[wet.index(column, row)] = 0;
}

void fill_river(TownRaster<double>& wet, const River& river) {
  for (std::size_t i = 0; i + 1 < river.axis.size(); ++i) {
    const double widest_m = std::max(river.width_m[i], river.width_m[i + 1]);
    fill_reach(wet, river.axis[i], river.axis[i + 1], std::max(widest_m / 2, wet.step_m * 0.7));
  }
}

// one pass of the chamfer transform; sign is 1 from the south-west, -1 from the north-east
void pass_distances(TownRaster<double>& wet, int sign) {
  const int n = wet.cells;
  const auto relax = [&](double& value, int column, int row, double cost) {
    if (column >= 0 && column <= n && row >= 0 && row <= n)
      value = std::min(value, wet.values[wet.index(column, row)] + cost * wet.step_m);
  };
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      const int column = sign > 0 ? i : n - i, row = sign > 0 ? j : n - j;
      double& value = wet.values[wet.index(column, row)];
      relax(value, column - sign, row, 1);
      relax(value, column, row - sign, 1);
      relax(value, column - sign, row - sign, 1.414);
      relax(value, column + sign, row - sign, 1.414);
    }
}

}  // namespace

WaterDistance water_distance(const Terrain& terrain, double side_m) {
  WaterDistance water{TownRaster<double>(side_m, std::max(4.0, side_m / 1250))};
  std::ranges::fill(water.distance_m.values, kFarFromWater_m);
  for (const Polygon& lake : terrain.lakes) fill_polygon(water.distance_m, lake);
  for (const Polygon& sea : terrain.sea) fill_polygon(water.distance_m, sea);
  for (const River& river : terrain.rivers) fill_river(water.distance_m, river);
  pass_distances(water.distance_m, 1);
  pass_distances(water.distance_m, -1);
  return water;
}

namespace {

/// Steps of the lattice of densities.
constexpr double kDensityStep_m = 32;
/// Centres of a city keep this distance, about that of the squares of its quarters.
constexpr double kCentreDistance_m = 1100;

struct KindRules {
  double peak, radius_m, side_share;  ///< Rules of the main centre: the radius is at most this share of the side.
  double floor;                       ///< The least density of the whole square.
};

KindRules rules_of(TownKind kind) {
  switch (kind) {
    case TownKind::kVillage:
      return {0.3, 330, 0.55, 0};
    case TownKind::kTown:
      return {0.72, 1500, 0.66, 0};
    default:
      return {1, 4500, 0.8, 0.26};
  }
}

// how well a place suits a centre: dry, flat, and near to where it is wanted
double centre_score(const TownPlan& plan, Vec2 p, Vec2 wanted) {
  const Vec2 slope = plan.terrain->gradient(p);
  const double wet = plan.water.at(p) < 60 ? 2 : 0;
  return length(slope) * 8 + wet + distance(p, wanted) / (plan.settings.side_m * 0.25);
}

Vec2 best_place(const TownPlan& plan, Vec2 wanted, double spread_m, Draws& draws) {
  Vec2 best = wanted;
  double least = centre_score(plan, wanted, wanted);
  for (int i = 0; i < 48; ++i) {
    const Vec2 p = wanted + direction_of(draws.unit()) * (spread_m * draws.unit());
    const double score = centre_score(plan, p, wanted);
    if (score < least) {
      least = score;
      best = p;
    }
  }
  return best;
}

Centre main_centre(const TownPlan& plan, Draws& draws) {
  const KindRules rules = rules_of(plan.settings.kind);
  const double side_m = plan.settings.side_m;
  const Vec2 position = best_place(plan, {0, 0}, side_m * 0.16, draws);
  const double radius_m = std::min(rules.radius_m, rules.side_share * side_m) * draws.between(0.9, 1.1);
  return {position, rules.peak, radius_m, direction_of(draws.unit())};
}

bool is_far_from_centres(const TownPlan& plan, Vec2 p) {
  return std::ranges::all_of(plan.centres,
                             [&](const Centre& c) { return distance(c.position, p) >= kCentreDistance_m; });
}

// adds centres of quarters where there is room: a city has them everywhere, a town has few
void add_quarters(TownPlan& plan) {
  const double side_m = plan.settings.side_m;
  const bool is_city = plan.settings.kind == TownKind::kCity;
  const auto tries = static_cast<std::uint64_t>(side_m * side_m / 1e6 * 12);
  const std::size_t most = is_city ? 1000 : 1 + static_cast<std::size_t>(std::min(side_m, 3000.0) / 1200);
  for (std::uint64_t i = 0; i < tries && plan.centres.size() < most; ++i) {
    Draws draws(plan.settings.seed, "centre", i + 1);
    const double room_m = is_city ? plan.half_m() * 0.92 : std::min(plan.half_m() * 0.7, 1300.0);
    const Vec2 p{draws.between(-room_m, room_m), draws.between(-room_m, room_m)};
    if (!is_far_from_centres(plan, p) || plan.water.at(p) < 80 || length(plan.terrain->gradient(p)) > 0.12) continue;
    const double peak = is_city ? draws.between(0.45, 0.68) : draws.between(0.3, 0.45);
    plan.centres.push_back({p, peak, draws.between(450, 800), direction_of(draws.unit())});
  }
}

double density_at(const TownPlan& plan, Vec2 p) {
  double density = rules_of(plan.settings.kind).floor;
  const double bend = 1 + 0.22 * smooth_noise(plan.settings.seed, p, 420);
  for (const Centre& centre : plan.centres) {
    const double share = distance(centre.position, p) * bend / centre.radius_m;
    if (share < 1) density = std::max(density, centre.peak * (1 - share) * (1 - 0.35 * share));
  }
  return density;
}

void fill_density(TownPlan& plan) {
  plan.density = TownRaster<double>(plan.settings.side_m, kDensityStep_m);
  for (int row = 0; row <= plan.density.cells; ++row)
    for (int column = 0; column <= plan.density.cells; ++column)
      plan.density.values[plan.density.index(column, row)] = density_at(plan, plan.density.place(column, row));
}

// parks: about one on each square kilometre of a city, one or two in a town
void add_reserves(TownPlan& plan) {
  if (plan.settings.kind == TownKind::kVillage) return;
  const double side_m = plan.settings.side_m;
  const auto count = static_cast<std::uint64_t>(std::max(1.0, side_m * side_m / 1e6 * 0.8));
  for (std::uint64_t i = 0; i < count; ++i) {
    Draws draws(plan.settings.seed, "reserve", i);
    const double radius_m = std::min(draws.between(60, 150), side_m * 0.09);
    const Vec2 p{draws.between(-0.46, 0.46) * side_m, draws.between(-0.46, 0.46) * side_m};
    if (plan.density.at(p) < 0.15 || plan.centre_distance_m(p) < radius_m + 130) continue;
    const bool is_apart = std::ranges::all_of(
        plan.reserves, [&](const Reserve& r) { return distance(r.middle, p) > r.radius_m + radius_m + 400; });
    if (is_apart) plan.reserves.push_back({p, radius_m});
  }
}

}  // namespace

bool TownPlan::is_reserved(Vec2 p) const {
  return std::ranges::any_of(reserves, [&](const Reserve& r) { return distance(r.middle, p) < r.radius_m; });
}

bool TownPlan::is_station_land(Vec2 p) const {
  if (!railway.has_station) return false;
  const double along_m = dot(p - railway.station, railway.along), town_m = dot(p - railway.station, railway.town);
  return along_m > -100 && along_m < 100 && town_m > -16 && town_m < 36;
}

double TownPlan::centre_distance_m(Vec2 p) const {
  double least = 1e9;
  for (const Centre& centre : centres) least = std::min(least, distance(centre.position, p));
  return least;
}

TownPlan plan_town(const Terrain& terrain, const TownSettings& settings) {
  TownPlan plan;
  plan.settings = settings;
  plan.terrain = &terrain;
  plan.water = water_distance(terrain, settings.side_m);
  Draws draws(settings.seed, "centre", 0);
  plan.centres.push_back(main_centre(plan, draws));
  if (settings.kind != TownKind::kVillage) add_quarters(plan);
  fill_density(plan);
  plan_railway(plan);
  add_reserves(plan);
  return plan;
}

}  // namespace citykiln::invent
