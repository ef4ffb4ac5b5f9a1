#include "compiler/ground/grading/carving.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <memory_resource>
#include <optional>

namespace citykiln::ground {
namespace {

// Rounded corners and turning circles reach no farther beyond the strips of their roads.
constexpr double kCorner_m = 12;

// Of the grid that tells where there is water at all.
constexpr double kBucket_m = 64;

// Of the grids that tell how far off what is near by is: about its reach.
constexpr double kNearBucket_m = 12;

// Room for the strands of nearly all places.
constexpr std::size_t kStrandBytes = 48 * sizeof(Strand);

// How far apart the heights are that a normal is made of.
constexpr double kNormalStep_m = 1;

// Walls and rock stand as steep as this between a higher road and what lies below it.
constexpr double kWallSlope = 1.5;

// What the land may be: from the least to the most, where earth lies; never above the wall.
struct Bounds {
  static constexpr double kFar_m = std::numeric_limits<double>::infinity();
  double least_m = -kFar_m, most_m = kFar_m, wall_m = kFar_m;
};

// What the land at a distance from an edge may differ from it in height: enough to meet the terrain within kCarve_m.
double rise_m(double slope, double away_m, double to_terrain_m) {
  return std::max(slope * away_m, std::abs(to_terrain_m) * (away_m / kCarve_m));
}

// A bank is raised to carry what is above, but no steeper than a wall may stand over what is below.
double within(const Bounds& bounds, double terrain_m) {
  return std::min(std::max(std::min(terrain_m, bounds.most_m), bounds.least_m), bounds.wall_m);
}

// By how much the place is nearer to what is paved than to the strips alone.
double corner_m(const Carving& carving, std::span<const Strand> strands, Vec2 p) {
  double nearest_m = kCorner_m;
  for (const Strand& s : strands)
    if (s.is_graded) nearest_m = std::min(nearest_m, s.beyond_m);
  if (nearest_m == 0 || nearest_m == kCorner_m || !carving.paved_map.box.contains(p)) return 0;
  return nearest_m - clearance_m(carving.paved_map, p, 0, nearest_m);
}

// The land keeps between the slopes that start at a height, so far away.
void keep_near(Bounds& bounds, double z_m, double away_m, double terrain_m) {
  const double earth_m = rise_m(kEarthSlope, away_m, terrain_m - z_m);
  bounds.least_m = std::max(bounds.least_m, z_m - earth_m);
  bounds.most_m = std::min(bounds.most_m, z_m + earth_m);
  bounds.wall_m = std::min(bounds.wall_m, z_m + rise_m(kWallSlope, away_m, terrain_m - z_m));
}

// A road that goes into a bore does not cut away the land over it.
double higher_m(const OverBores& over, double road_m) {
  // roads that pass over the bore start above its roof
  constexpr double kShared_m = 2;
  return over.higher_m * std::clamp((over.roof_m - road_m) / kShared_m, 0.0, 1.0);
}

// Slopes start at the road's edge from what the roads agree on there, farther off from the height of the road alone.
void keep_near_roads(Bounds& bounds, std::span<const Strand> strands, double nearer_m, double road_m, double terrain_m,
                     const OverBores& over) {
  for (const Strand& s : strands) {
    if (!s.is_graded) continue;
    const double away_m = std::max(0.0, s.beyond_m - nearer_m);
    Bounds here;
    keep_near(here, road_m + (s.z_m - road_m) * std::min(1.0, away_m / kBlend_m), away_m, terrain_m);
    bounds.least_m = std::max(bounds.least_m, here.least_m);
    bounds.most_m = std::min(bounds.most_m, here.most_m + higher_m(over, s.z_m));
    bounds.wall_m = std::min(bounds.wall_m, here.wall_m + higher_m(over, s.z_m));
  }
}

// All that may be felt at half of kCarve_m, nothing at kCarve_m.
double share_of(double away_m) { return std::min(1.0, (kCarve_m - away_m) / (kCarve_m / 2)); }

// How much of a road is felt: nothing where no road is in reach, all from half of it on.
double road_share(std::span<const Strand> strands) {
  double nearest_m = kCarve_m;
  for (const Strand& s : strands) nearest_m = std::min(nearest_m, s.beyond_m);
  return share_of(nearest_m);
}

// Water near by: how high, and how far off.
struct NearWater {
  double z_m, shore_m;
};

// Only what is near counts: farther off, what is known depends on who asks.
std::optional<NearWater> water_near(const Carving& carving, Vec2 p) {
  if (boxes_about(carving.shores, p).empty() || !carving.wet_map.box.contains(p)) return std::nullopt;
  const double shore_m = clearance_m(carving.wet_map, p, 0, kCarve_m);
  if (shore_m >= kCarve_m) return std::nullopt;
  const std::optional<double> z_m = water_m(carving.waters, p);
  if (!z_m) return std::nullopt;
  return NearWater{*z_m, shore_m};
}

Bounds bounds_at(const Carving& carving, std::span<const Strand> strands, const RoadHeight& road,
                 const std::optional<NearWater>& water, Vec2 p, double terrain_m) {
  Bounds bounds;
  const OverBores over = over_bores(carving.bores, p);
  keep_near_roads(bounds, strands, corner_m(carving, strands, p), road.z_m, terrain_m, over);
  bounds.least_m = std::max(bounds.least_m, over.least_m);
  // no bank reaches under a deck, not even the one that carries the road before it
  bounds.wall_m = std::min(bounds.wall_m, most_under_decks_m(carving.decks, p));
  if (water) keep_near(bounds, water->z_m, water->shore_m, terrain_m);
  return bounds;
}

bool is_near_span(const Carving& carving, Vec2 p) {
  return !boxes_about(carving.decks.field.grid, p).empty() || !boxes_about(carving.bores.field.grid, p).empty();
}

// Banks are carved as far from the shore as from roads.
std::vector<roads::Strip> felt_beyond(std::span<const roads::Strip> streams) {
  std::vector<roads::Strip> felt(streams.begin(), streams.end());
  for (roads::Strip& stream : felt) stream.reach_m = reach_m(stream) + kCarve_m;
  return felt;
}

std::vector<Box2> reaches_of(std::span<const Surface> surfaces) {
  std::vector<Box2> boxes;
  for (const Surface& s : surfaces)
    for (const Ring& ring : s.rings) boxes.push_back(box_of(ring).widened(kCarve_m));
  return boxes;
}

std::vector<Surface> on_layers(std::span<const Surface> surfaces, std::span<const HeightLayer> layers) {
  std::vector<Surface> chosen;
  for (const Surface& s : surfaces)
    if (std::ranges::find(layers, layer_of(s)) != layers.end()) chosen.push_back(s);
  return chosen;
}

}  // namespace

Carving::Carving(map::Heightfield&& field) : terrain(std::move(field)) {}

Carving carve(map::Heightfield terrain, const CarvingParts& parts) {
  constexpr HeightLayer kPaved[] = {HeightLayer::kRoad, HeightLayer::kCarriageway}, kWet[] = {HeightLayer::kWater};
  Carving carving(std::move(terrain));
  carving.roads = field_of(parts.roads, parts.has_kerbs);
  carving.decks = span_field_of(parts.decks), carving.bores = span_field_of(parts.bores);
  // maps know no borders outside their box, and places at its sides feel what lies beyond
  const Box2 felt = parts.box.widened(kCarve_m);
  carving.waters = index_waters(parts.surfaces, felt_beyond(parts.streams), felt);
  carving.paved = on_layers(parts.surfaces, kPaved), carving.wet = on_layers(parts.surfaces, kWet);
  carving.paved_map = map_surfaces(carving.paved, felt, kNearBucket_m);
  carving.wet_map = map_surfaces(carving.wet, felt, kNearBucket_m);
  carving.shores = grid_of(reaches_of(carving.wet), kBucket_m);
  return carving;
}

Sounding sound(const Carving& carving, Vec2 p) {
  const double terrain_m = map::height_m_at(carving.terrain, p);
  std::array<std::byte, kStrandBytes> room;
  std::pmr::monotonic_buffer_resource memory(room.data(), room.size());
  const std::pmr::vector<Strand> strands = strands_at(carving.roads, p, terrain_m, &memory);
  const std::optional<NearWater> water = water_near(carving, p);
  if (strands.empty() && !water && !is_near_span(carving, p))
    return {{terrain_m, terrain_m, terrain_m, terrain_m}, terrain_m};
  const RoadHeight road = strands.empty() ? RoadHeight{terrain_m, 0} : blend(strands);
  const Bounds bounds = bounds_at(carving, strands, road, water, p, terrain_m);
  const double land_m = within(bounds, terrain_m);
  const double share = road_share(strands), road_m = land_m + (road.z_m - land_m) * share;
  const double water_m = water ? land_m + (water->z_m - land_m) * share_of(water->shore_m) : land_m;
  return {{land_m, road_m, road_m - road.kerb_m * share, water_m}, terrain_m};
}

Heights heights_at(const Carving& carving, Vec2 p) { return sound(carving, p).heights; }

double land_m(const Carving& carving, Vec2 p) { return of(heights_at(carving, p), HeightLayer::kLand); }

std::array<Vec3, kHeightLayers> normals_at(const Carving& carving, Vec2 p) {
  std::array<Vec3, kHeightLayers> normals;
  normals.fill(map::normal_at(carving.terrain, p));
  if (!is_carved(carving, {p, p})) return normals;
  constexpr Vec2 kEast{kNormalStep_m, 0}, kNorth{0, kNormalStep_m};
  const Sounding east = sound(carving, p + kEast), west = sound(carving, p - kEast), north = sound(carving, p + kNorth),
                 south = sound(carving, p - kNorth);
  std::optional<Sounding> centre;
  for (std::size_t layer = 0; layer < kHeightLayers; ++layer) {
    const auto is_terrain = [&](const Sounding& s) { return s.heights[layer] == s.terrain_m; };
    if (is_terrain(east) && is_terrain(west) && is_terrain(north) && is_terrain(south)) {
      if (!centre) centre = sound(carving, p);
      if (is_terrain(*centre)) continue;
    }
    const double dx = east.heights[layer] - west.heights[layer], dy = north.heights[layer] - south.heights[layer];
    normals[layer] = unit(Vec3{-dx, -dy, 2 * kNormalStep_m});
  }
  return normals;
}

bool is_carved(const Carving& carving, const Box2& box) {
  for (const BoxGrid* grid :
       {&carving.roads.grid, &carving.shores, &carving.decks.field.grid, &carving.bores.field.grid})
    if (is_any_about(*grid, box)) return true;
  return false;
}

}  // namespace citykiln::ground
