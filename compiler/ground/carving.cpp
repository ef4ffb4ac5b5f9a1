#include "compiler/ground/carving.h"

#include <algorithm>
#include <limits>

namespace citykiln::ground {
namespace {

// Rounded corners and turning circles reach no farther beyond the strips of their roads.
constexpr double kCorner_m = 12;

// How far apart the heights are that a normal is made of.
constexpr double kNormalStep_m = 1;

// The least and the most that the land may be.
struct Bounds {
  double least_m = -std::numeric_limits<double>::infinity(), most_m = std::numeric_limits<double>::infinity();
};

// What earth at a distance from an edge may differ from it in height: enough to meet the terrain within kCarve_m.
double slope_m(double away_m, double to_terrain_m) {
  return std::max(kEarthSlope * away_m, std::abs(to_terrain_m) * (away_m / kCarve_m));
}

// By how much the place is nearer to what is paved than to the strips alone.
double corner_m(const Carving& carving, std::span<const Strand> strands, Vec2 p) {
  double nearest_m = kCorner_m;
  for (const Strand& s : strands)
    if (s.is_graded) nearest_m = std::min(nearest_m, s.beyond_m);
  if (nearest_m == 0 || nearest_m == kCorner_m || !carving.paved_map.box.contains(p)) return 0;
  return nearest_m - clearance_m(carving.paved_map, p, 0, nearest_m);
}

Bounds bounds_at(const Carving& carving, std::span<const Strand> strands, Vec2 p, double terrain_m) {
  Bounds bounds;
  const double nearer_m = corner_m(carving, strands, p);
  for (const Strand& s : strands) {
    if (!s.is_graded) continue;
    const double slope = slope_m(std::max(0.0, s.beyond_m - nearer_m), terrain_m - s.z_m);
    bounds.least_m = std::max(bounds.least_m, s.z_m - slope);
    bounds.most_m = std::min(bounds.most_m, s.z_m + slope);
  }
  return bounds;
}

double height_of(const Carving& carving, Vec2 p, HeightLayer layer) { return of(heights_at(carving, p), layer); }

}  // namespace

Carving::Carving(map::Heightfield&& field) : terrain(std::move(field)) {}

Carving carve(map::Heightfield terrain, std::span<const roads::Road> roads, std::vector<Surface> paved, const Box2& box,
              bool has_kerbs) {
  Carving carving(std::move(terrain));
  carving.roads = field_of(roads, has_kerbs);
  carving.paved = std::move(paved);
  carving.paved_map = map_surfaces(carving.paved, box);
  return carving;
}

Heights heights_at(const Carving& carving, Vec2 p) {
  const double terrain_m = map::height_m_at(carving.terrain, p);
  const std::vector<Strand> strands = strands_at(carving.roads, p, terrain_m);
  if (strands.empty()) return {terrain_m, terrain_m, terrain_m, terrain_m};
  const Bounds bounds = bounds_at(carving, strands, p, terrain_m);
  // what is below wins: the higher road keeps its edge by a wall
  const double land_m = std::min(std::max(terrain_m, bounds.least_m), bounds.most_m);
  const RoadHeight road = blend(strands);
  return {land_m, road.z_m, road.z_m - road.kerb_m, land_m};
}

double land_m(const Carving& carving, Vec2 p) { return of(heights_at(carving, p), HeightLayer::kLand); }

Vec3 normal_at(const Carving& carving, Vec2 p, HeightLayer layer) {
  if (boxes_about(carving.roads.grid, p).empty()) return map::normal_at(carving.terrain, p);
  const Vec2 east{kNormalStep_m, 0}, north{0, kNormalStep_m};
  const double dx = height_of(carving, p + east, layer) - height_of(carving, p - east, layer);
  const double dy = height_of(carving, p + north, layer) - height_of(carving, p - north, layer);
  return unit(Vec3{-dx, -dy, 2 * kNormalStep_m});
}

bool is_level(const Carving& carving, const Box2& box) {
  if (!boxes_about(carving.roads.grid, box).empty()) return false;
  const map::Heightfield window = map::window_of(carving.terrain, box);
  return std::ranges::adjacent_find(window.heights, std::ranges::not_equal_to{}) == window.heights.end();
}

}  // namespace citykiln::ground
