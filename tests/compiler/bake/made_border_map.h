// Small random maps about the border of two tiles: roads with and without kerbs, brooks, coasts, ponds, buildings and
// areas, on level, rolling or rough terrain. Many of their points lie on the border, or within a few grid steps of it.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "compiler/contract/random_sequence.h"
#include "compiler/contract/tolerance.h"
#include "compiler/geometry/snap.h"
#include "compiler/ground/cover/strip_cover.h"
#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/ground/recipe.h"
#include "tests/compiler/roads/made_road.h"

namespace citykiln::bake {

// The line between the tiles. Tiles are small, so that many maps can be tried.
inline constexpr double kMadeBorder_m = 128, kMadeTile_m = 32;

struct MadeBorderMap {
  std::vector<roads::Road> roads;
  std::vector<roads::Strip> streams;
  std::vector<ground::LandCoverPolygon> surfaces;  ///< Areas, roads and streams, sorted by id, class and piece.
  map::Heightfield terrain;
  Box2 first, second;  ///< The tiles, side by side or one above the other.
};

/// Random numbers in the order of calls.
struct Dice {
  RandomSequence draw;
  std::uint32_t next = 0;

  double between(double low, double high) { return draw.between(low, high, next++); }
  std::uint32_t below(std::uint32_t count) { return draw.below(count, next++); }
  bool is(double share) { return draw.unit(next++) < share; }
};

/// Makes the parts of one map; x = 128 is the border, before the map is turned.
struct BorderMapMaker {
  Dice dice;
  MadeBorderMap made{};
  std::int64_t next_id = 1;

  double share_beside = 0.3;  // share of points that lie on the border or beside it

  // A coordinate near a side of a tile: on it, or some steps of the map's grid or of the plane's grid beside it.
  double beside(double side_m) {
    const double step_m = dice.is(0.5) ? kQuantum_m : kMapQuantum_m;
    return side_m + (static_cast<double>(dice.below(9)) - 4) * step_m * (dice.is(0.5) ? 0 : 1);
  }

  double x(double from_m, double to_m) {
    return dice.is(share_beside) ? beside(kMadeBorder_m) : on_map(dice.between(from_m, to_m));
  }
  double y(double from_m, double to_m) {
    if (dice.is(0.1)) return beside(dice.is(0.5) ? 0 : kMadeTile_m);
    return on_map(dice.between(from_m, to_m));
  }
  static double on_map(double v) { return std::floor(v / kMapQuantum_m + 0.5) * kMapQuantum_m; }

  static constexpr double kMapQuantum_m = 0x1p-7;

  Vec2 point(double reach_m) {
    const double px = x(kMadeBorder_m - reach_m, kMadeBorder_m + reach_m);
    return {px, y(-12, kMadeTile_m + 12)};
  }

  ObjectId id() { return {{OsmType::kWay, next_id++}, 0}; }

  void add_area(map::LandCoverClass surface, Ring ring) {
    if (signed_area_m2(ring) < 0) std::ranges::reverse(ring);
    const auto area_m2 = static_cast<std::uint32_t>(std::max(3.0, signed_area_m2(ring)));
    made.surfaces.push_back({id(), surface, area_m2, {std::move(ring)}});
    const bool stands = surface == map::LandCoverClass::kLake || surface == map::LandCoverClass::kSea;
    if (!stands) return;
    made.surfaces.back().level_m = surface == map::LandCoverClass::kSea ? 0 : dice.below(80) / 16.0;
  }

  Ring quad() {
    const Vec2 a = point(20);
    const double width_m = on_map(dice.between(0.1, 24)), depth_m = on_map(dice.between(0.1, 30));
    Ring ring = {a, {a.x + width_m, a.y}, {a.x + width_m, a.y + depth_m}, {a.x, a.y + depth_m}};
    for (Vec2& p : ring)
      if (dice.is(0.2)) p = {x(104, 152), p.y};
    return ring;
  }

  Ring outline() {
    Ring ring;
    const std::uint32_t count = 3 + dice.below(6);
    if (dice.is(0.5)) return quad();
    for (std::uint32_t i = 0; i < count; ++i) ring.push_back(point(24));
    const Vec2 middle{kMadeBorder_m + dice.between(-10, 10), dice.between(4, 28)};
    const auto is_before = [&](Vec2 a, Vec2 b) {
      const bool a_up = a.y >= middle.y, b_up = b.y >= middle.y;
      return a_up != b_up ? a_up : cross(a - middle, b - middle) > 0;
    };
    std::ranges::stable_sort(ring, is_before);
    return ring;
  }

  // A line that runs along the border, crosses it or ends on it.
  Polyline line() {
    Polyline axis = {point(30)};
    const std::uint32_t count = 1 + dice.below(4);
    for (std::uint32_t i = 0; i < count; ++i)
      if (const Vec2 p = point(30); distance(p, axis.back()) > 2) axis.push_back(p);
    if (axis.size() < 2) axis.push_back({axis[0].x + 30, axis[0].y + 11});
    return axis;
  }

  Profile profile(double base_m) {
    Profile knots;
    for (int i = 0; i < 12; ++i) knots.push_back({i * 16.0, base_m + dice.below(96) / 16.0, 0});
    return knots;
  }

  void add_road() {
    constexpr map::LandCoverClass kClasses[] = {map::LandCoverClass::kResidentialRoad,
                                                map::LandCoverClass::kServiceRoad, map::LandCoverClass::kFootPath,
                                                map::LandCoverClass::kPrimaryRoad};
    const double pavement_m = dice.is(0.5) ? 1.5 : 0;
    roads::Road road = roads::made_road(next_id++, line(), 2 + dice.below(6), kClasses[dice.below(4)], pavement_m,
                                        dice.is(0.5) ? pavement_m : 0);
    if (dice.is(0.8)) road.profile = profile(dice.below(40) / 8.0);
    made.surfaces.push_back(ground::surface_of(road, {true, {}, {}}));
    if (ground::LandCoverPolygon pavement = ground::pavement_of(road, {}); !pavement.rings.empty())
      made.surfaces.push_back(std::move(pavement));
    made.roads.push_back(std::move(road));
  }

  void add_stream() {
    const double half_m = (1 + dice.below(16)) / 4.0;
    roads::Strip stream{
        .id = id(), .axis = line(), .surface = map::LandCoverClass::kRiver, .left_m = half_m, .right_m = half_m};
    for (int i = 0; i < 12; ++i) stream.profile.push_back({i * 16.0, 4 - i / 4.0, 0});
    made.surfaces.push_back(ground::surface_of(stream));
    made.streams.push_back(std::move(stream));
  }

  // The sea on one side of a shore that stays near the border.
  void add_coast() {
    Ring ring;
    for (double at_m = -40; at_m < 80; at_m += on_map(dice.between(1, 20)))
      ring.push_back({dice.is(0.6) ? beside(kMadeBorder_m) : x(118, 138), at_m});
    const double far_m = dice.is(0.5) ? 0 : 256;
    ring.push_back({far_m, 100}), ring.push_back({far_m, -60});
    add_area(map::LandCoverClass::kSea, std::move(ring));
  }

  void add_part() {
    constexpr map::LandCoverClass kAreas[] = {
        map::LandCoverClass::kMeadow, map::LandCoverClass::kForest,      map::LandCoverClass::kBeach,
        map::LandCoverClass::kLake,   map::LandCoverClass::kResidential, map::LandCoverClass::kBuilding,
        map::LandCoverClass::kPier,   map::LandCoverClass::kParking,     map::LandCoverClass::kBuilding};
    const std::uint32_t kind = dice.below(16);
    if (kind < 9) return add_area(kAreas[kind], outline());
    if (kind == 9) return add_coast();
    kind < 12 ? add_stream() : add_road();
  }

  void add_terrain() {
    constexpr double kSteps_m[] = {128, 64, 32, 16, 15, 9.5, 24.5};
    const double step_m = kSteps_m[dice.below(7)];
    constexpr double kRoughness_m[] = {0, 0, 0.5, 4, 16};
    const double rough_m = kRoughness_m[dice.below(5)];
    const int before = static_cast<int>(std::ceil(64 / step_m)), count = static_cast<int>(std::ceil(320 / step_m)) + 1;
    made.terrain = {{-before * step_m, -before * step_m}, {step_m, step_m}, count, count, {}, 0};
    for (int i = 0; i < count * count; ++i)
      made.terrain.heights.push_back(static_cast<std::int32_t>(dice.between(0, rough_m) / map::kHeightQuantum_m));
  }
};

inline void turn_map(MadeBorderMap& map) {
  const auto turned = [](Vec2 p) { return Vec2{p.y, p.x}; };
  for (roads::Road& road : map.roads) std::ranges::transform(road.axis, road.axis.begin(), turned);
  for (roads::Strip& stream : map.streams) std::ranges::transform(stream.axis, stream.axis.begin(), turned);
  for (ground::LandCoverPolygon& surface : map.surfaces)
    for (Ring& ring : surface.rings) {
      std::ranges::transform(ring, ring.begin(), turned);
      std::ranges::reverse(ring);
    }
  for (Box2* tile : {&map.first, &map.second}) *tile = {turned(tile->min), turned(tile->max)};
}

/// Returns the map of a seed.
inline MadeBorderMap made_border_map(std::uint64_t seed) {
  BorderMapMaker maker{{RandomSequence(seed, StableId{7}, "map about a border")}};
  constexpr double kShares[] = {0.1, 0.3, 0.6, 0.9};
  maker.share_beside = kShares[maker.dice.below(4)];
  maker.add_terrain();
  const std::uint32_t parts = 1 + maker.dice.below(9);
  for (std::uint32_t i = 0; i < parts; ++i) maker.add_part();
  MadeBorderMap map = std::move(maker.made);
  map.first = {{kMadeBorder_m - kMadeTile_m, 0}, {kMadeBorder_m, kMadeTile_m}};
  map.second = {{kMadeBorder_m, 0}, {kMadeBorder_m + kMadeTile_m, kMadeTile_m}};
  if (maker.dice.is(0.3)) turn_map(map);
  return map;
}

}  // namespace citykiln::bake
