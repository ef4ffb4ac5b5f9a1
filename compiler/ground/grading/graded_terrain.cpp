#include "compiler/ground/grading/graded_terrain.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <limits>
#include <memory_resource>
#include <optional>

#include "compiler/ground/cover/strip_cover.h"

namespace citykiln::ground {
namespace {

// Rounded corners and turning circles extend at most this far beyond the strips of their roads.
constexpr double kCorner_m = 12;

// Buckets of the index that says where there is water near.
constexpr double kShoreBucket_m = 64;

// Buckets of the distance indices: about as wide as the distances asked for.
constexpr double kNearBucket_m = 12;

// Room for the influences of nearly all places.
constexpr std::size_t kInfluenceBytes = 48 * sizeof(RoadInfluence);

// A normal is made of heights this far from the place.
constexpr double kNormalStep_m = 1;

// Steepest slope between a higher road and what lies below it: retaining walls and rock.
constexpr double kWallSlope = 1.5;

// The bounds of the land's height: at least and at most, by slopes of earth, and never above the wall.
struct Bounds {
  static constexpr double kFar_m = std::numeric_limits<double>::infinity();
  double least_m = -kFar_m, most_m = kFar_m, wall_m = kFar_m;
};

// The land at a distance from an edge may differ from it by this much: the slope, or steeper where that would not meet
// the terrain within kGrading_m.
double bank_rise_m(double slope, double away_m, double to_terrain_m) {
  return std::max(slope * away_m, std::abs(to_terrain_m) * (away_m / kGrading_m));
}

// A bank is raised to carry what lies above, but stands no steeper than a wall over what lies below.
double within_bounds(const Bounds& bounds, double terrain_m) {
  return std::min(std::max(std::min(terrain_m, bounds.most_m), bounds.least_m), bounds.wall_m);
}

// How much nearer the place is to paved polygons, with their rounded corners, than to the roads' strips.
double corner_m(const GradedTerrain& graded, std::span<const RoadInfluence> influences, Vec2 p) {
  double nearest_m = kCorner_m;
  for (const RoadInfluence& s : influences)
    if (s.is_graded) nearest_m = std::min(nearest_m, s.beyond_m);
  if (nearest_m == 0 || nearest_m == kCorner_m || !graded.paved_index.box.contains(p)) return 0;
  return nearest_m - clearance_m(graded.paved_index, p, 0, nearest_m);
}

// How much farther the land may be above and below a slope, since a step lies between the place and the slope's start.
struct StepRoom {
  double above_m = 0, below_m = 0;
};

StepRoom room_across(const std::optional<StepSide>& step, double away_m) {
  // a slope that starts this much nearer than the step does not cross it
  constexpr double kBefore_m = 0.5;
  if (!step) return {};
  const double between = std::clamp((away_m - step->away_m) / kBefore_m + 1, 0.0, 1.0) * step->rise_m;
  return {between * step->high_share, between * (1 - step->high_share)};
}

// Keeps the land between the slopes that start at a height, `away_m` away.
void bound_by_slopes(Bounds& bounds, double z_m, double away_m, double terrain_m, const StepRoom& room) {
  const double earth_m = bank_rise_m(kEarthSlope, away_m, terrain_m - z_m);
  bounds.least_m = std::max(bounds.least_m, z_m - earth_m - room.below_m);
  bounds.most_m = std::min(bounds.most_m, z_m + earth_m + room.above_m);
  bounds.wall_m = std::min(bounds.wall_m, z_m + bank_rise_m(kWallSlope, away_m, terrain_m - z_m) + room.above_m);
}

// The land over a bore is not cut down to the road that leads into it.
double higher_m(const BoreCover& over, double road_m) {
  // roads that pass over the bore start above its roof
  constexpr double kShared_m = 2;
  return over.higher_m * std::clamp((over.roof_m - road_m) / kShared_m, 0.0, 1.0);
}

// A slope starts at the road's edge from the blended height of all roads, and from kBlend_m on from its road's own.
void bound_by_roads(Bounds& bounds, std::span<const RoadInfluence> influences, double nearer_m, double road_m,
                    double terrain_m, const BoreCover& over, const std::optional<StepSide>& step) {
  for (const RoadInfluence& s : influences) {
    if (!s.is_graded) continue;
    const double away_m = std::max(0.0, s.beyond_m - nearer_m);
    Bounds here;
    bound_by_slopes(here, road_m + (s.z_m - road_m) * std::min(1.0, away_m / kBlend_m), away_m, terrain_m,
                    room_across(step, away_m));
    const double room_m = std::max(higher_m(over, s.z_m), s.wall_m);
    bounds.least_m = std::max(bounds.least_m, here.least_m);
    bounds.most_m = std::min(bounds.most_m, here.most_m + room_m);
    bounds.wall_m = std::min(bounds.wall_m, here.wall_m + room_m);
  }
}

// 1 up to kGrading_m / 2, then falls linearly to 0 at kGrading_m.
double grading_share(double away_m) { return std::min(1.0, (kGrading_m - away_m) / (kGrading_m / 2)); }

// The weight of roads against the land at a place.
double road_share(std::span<const RoadInfluence> influences) {
  double nearest_m = kGrading_m;
  for (const RoadInfluence& s : influences) nearest_m = std::min(nearest_m, s.beyond_m);
  return grading_share(nearest_m);
}

// The height of the nearest water and the distance to its shore.
struct NearWater {
  double z_m, shore_m;
};

// Water beyond kGrading_m is ignored: whether it is known depends on the tile.
std::optional<NearWater> water_near(const GradedTerrain& graded, Vec2 p) {
  if (boxes_about(graded.shores, p).empty() || !graded.wet_index.box.contains(p)) return std::nullopt;
  const double shore_m = clearance_m(graded.wet_index, p, 0, kGrading_m);
  if (shore_m >= kGrading_m) return std::nullopt;
  const std::optional<double> z_m = water_m(graded.waters, p);
  if (!z_m) return std::nullopt;
  return NearWater{*z_m, shore_m};
}

Bounds bounds_at(const GradedTerrain& graded, std::span<const RoadInfluence> influences, const RoadHeight& road,
                 const std::optional<NearWater>& water, Vec2 p, const LandformHeights& land) {
  Bounds bounds;
  const BoreCover over = bore_cover_at(graded.bores, p);
  bound_by_roads(bounds, influences, corner_m(graded, influences, p), road.z_m, land.land_m, over, land.step);
  bounds.least_m = std::max(bounds.least_m, over.least_m);
  // no bank extends under a deck, not even the one that carries the road before it
  bounds.wall_m = std::min(bounds.wall_m, max_land_under_decks_m(graded.decks, p));
  if (water) bound_by_slopes(bounds, water->z_m, water->shore_m, land.land_m, room_across(land.step, water->shore_m));
  return bounds;
}

bool is_near_span(const GradedTerrain& graded, Vec2 p) {
  return !boxes_about(graded.decks.roads.grid, p).empty() || !boxes_about(graded.bores.roads.grid, p).empty();
}

// Banks of watercourses are graded as far from the shore as those of roads, so their heights are needed there.
std::vector<roads::Strip> with_grading_margin(std::span<const roads::Strip> streams) {
  std::vector<roads::Strip> wider(streams.begin(), streams.end());
  for (roads::Strip& stream : wider) stream.influence_radius_m = influence_radius_m(stream) + kGrading_m;
  return wider;
}

std::vector<Box2> reaches_of(std::span<const LandCoverPolygon> surfaces) {
  std::vector<Box2> boxes;
  for (const LandCoverPolygon& s : surfaces)
    for (const Ring& ring : s.rings) boxes.push_back(box_of(ring).widened(kGrading_m));
  return boxes;
}

// Polygons of water: the strips of all watercourses, whether they are among the surfaces or not, and areas.
std::vector<LandCoverPolygon> wet_of(const GradingInputs& parts) {
  std::vector<LandCoverPolygon> wet;
  for (const roads::Strip& stream : parts.streams) wet.push_back(surface_of(stream));
  std::vector<ObjectId> strips;
  for (const LandCoverPolygon& strip : wet) strips.push_back(strip.id);
  std::ranges::sort(strips);
  for (const LandCoverPolygon& s : parts.surfaces)
    if (layer_of(s) == HeightLayer::kWater && !std::ranges::binary_search(strips, s.id)) wet.push_back(s);
  return wet;
}

std::vector<LandCoverPolygon> paved_of(std::span<const LandCoverPolygon> surfaces) {
  std::vector<LandCoverPolygon> paved;
  for (const LandCoverPolygon& s : surfaces)
    if (layer_of(s) == HeightLayer::kRoad || layer_of(s) == HeightLayer::kCarriageway) paved.push_back(s);
  return paved;
}

}  // namespace

GradedTerrain::GradedTerrain(map::Heightfield&& field) : terrain(std::move(field)) {}

GradedTerrain grade_terrain(map::Heightfield terrain, const GradingInputs& parts) {
  GradedTerrain graded(std::move(terrain));
  graded.roads = index_road_influence(parts.roads, parts.has_kerbs);
  graded.kerb_ramps = roads::index_kerb_ramps({parts.kerb_ramps.begin(), parts.kerb_ramps.end()});
  graded.decks = index_span_influence(parts.decks), graded.bores = index_span_influence(parts.bores);
  graded.landforms = index_landforms(parts.landforms);
  // an index knows no borders outside its box, and places at its sides depend on what lies beyond
  const Box2 influenced = parts.box.widened(kGrading_m);
  graded.waters = index_waters(parts.surfaces, with_grading_margin(parts.streams), influenced);
  graded.paved = paved_of(parts.surfaces), graded.wet = wet_of(parts);
  graded.paved_index = index_land_cover(graded.paved, influenced, kNearBucket_m);
  graded.wet_index = index_land_cover(graded.wet, influenced, kNearBucket_m);
  graded.shores = grid_of(reaches_of(graded.wet), kShoreBucket_m);
  return graded;
}

HeightSample sample_heights(const GradedTerrain& graded, Vec2 p) {
  const double terrain_m = map::height_m_at(graded.terrain, p);
  const LandformHeights land = landform_heights(graded.landforms, p, terrain_m);
  std::array<std::byte, kInfluenceBytes> room;
  std::pmr::monotonic_buffer_resource memory(room.data(), room.size());
  const std::pmr::vector<RoadInfluence> influences = road_influences_at(graded.roads, p, land.land_m, &memory);
  const std::optional<NearWater> water = water_near(graded, p);
  if (influences.empty() && !water && !is_near_span(graded, p)) {
    const double land_m = std::max(land.land_m, land.deck_m);
    // water whose height is not known lies below decks
    return {{land_m, land_m, land_m, land.land_m}, terrain_m};
  }
  const RoadHeight road = influences.empty() ? RoadHeight{land.land_m, 0} : blend(influences);
  const Bounds bounds = bounds_at(graded, influences, road, water, p, land);
  const double below_decks_m = within_bounds(bounds, land.land_m), land_m = std::max(below_decks_m, land.deck_m);
  const double share = road_share(influences), road_m = land_m + (road.z_m - land_m) * share;
  const double water_m = water ? land_m + (water->z_m - land_m) * grading_share(water->shore_m) : below_decks_m;
  const double kerb_m = road.kerb_m * share;
  return {{land_m, road_m - roads::dropped_m(graded.kerb_ramps, p, kerb_m), road_m - kerb_m, water_m}, terrain_m};
}

Heights heights_at(const GradedTerrain& graded, Vec2 p) { return sample_heights(graded, p).heights; }

double land_m(const GradedTerrain& graded, Vec2 p) { return layer_height_m(heights_at(graded, p), HeightLayer::kLand); }

double wall_ground_m(const GradedTerrain& graded, Vec2 p) {
  constexpr double kLeastStep_m = 0.25, kOnRoad_m = 0.125;
  const Heights heights = heights_at(graded, p);
  const double land_m = layer_height_m(heights, HeightLayer::kLand);
  const double road_m = layer_height_m(heights, HeightLayer::kCarriageway);
  const bool is_lower = road_m < land_m - kLeastStep_m && graded.paved_index.box.contains(p);
  return is_lower && clearance_m(graded.paved_index, p, 0, 1) <= kOnRoad_m ? road_m : land_m;
}

std::array<Vec3, kHeightLayers> normals_at(const GradedTerrain& graded, Vec2 p) {
  std::array<Vec3, kHeightLayers> normals;
  normals.fill(map::normal_at(graded.terrain, p));
  if (!has_grading(graded, {p, p})) return normals;
  constexpr Vec2 kEast{kNormalStep_m, 0}, kNorth{0, kNormalStep_m};
  const HeightSample east = sample_heights(graded, p + kEast), west = sample_heights(graded, p - kEast),
                     north = sample_heights(graded, p + kNorth), south = sample_heights(graded, p - kNorth);
  std::optional<HeightSample> centre;
  for (std::size_t layer = 0; layer < kHeightLayers; ++layer) {
    const auto is_terrain = [&](const HeightSample& s) { return s.heights[layer] == s.terrain_m; };
    if (is_terrain(east) && is_terrain(west) && is_terrain(north) && is_terrain(south)) {
      if (!centre) centre = sample_heights(graded, p);
      if (is_terrain(*centre)) continue;
    }
    const double dx = east.heights[layer] - west.heights[layer], dy = north.heights[layer] - south.heights[layer];
    normals[layer] = unit(Vec3{-dx, -dy, 2 * kNormalStep_m});
  }
  return normals;
}

bool has_grading(const GradedTerrain& graded, const Box2& box) {
  for (const BoxGrid* grid :
       {&graded.roads.grid, &graded.shores, &graded.decks.roads.grid, &graded.bores.roads.grid, &graded.landforms.grid})
    if (is_any_about(*grid, box)) return true;
  return false;
}

}  // namespace citykiln::ground
