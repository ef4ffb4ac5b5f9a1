#include "compiler/verify/heights/heights_json.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "compiler/contract/detail_tolerances.h"
#include "compiler/contract/system/for_each_slot.h"
#include "compiler/contract/tolerance.h"
#include "compiler/scene/graded_terrain.h"
#include "compiler/scene/land_cover.h"

namespace citykiln::verify {
namespace {

/// Fine enough for kerbs.
constexpr double kFine_m = tolerances_with(Detail::kRoadSurfaces).below_m / 2;

Lakes lakes_of(const scene::Chunk& chunk, const Box2& box, const ground::GradedTerrain& graded) {
  Lakes lakes;
  for (const ground::LandCoverPolygon& surface : chunk.surfaces) {
    if (!surface.level_m) continue;
    const auto off_m = [&](Vec2 p) {
      return std::abs(layer_height_m(heights_at(graded, p), ground::HeightLayer::kWater) - *surface.level_m);
    };
    double deviation_m = 0;
    for (const Ring& ring : surface.rings)
      for (const Vec2 p : ring)
        if (box.contains(p)) deviation_m = std::max(deviation_m, off_m(p));
    ++lakes.waters;
    lakes.not_level += deviation_m > kQuantum_m;
    if (deviation_m > lakes.largest_m) lakes.largest_m = deviation_m, lakes.worst = surface.id.osm;
  }
  return lakes;
}

RoadFaces graded_road_faces(const scene::Chunk& chunk, const Box2& box, const ground::GradedTerrain& graded) {
  return measure_road_faces(chunk, box, true, [&](const roads::Road&, Vec2 p) -> std::vector<double> {
    return {layer_height_m(heights_at(graded, p), ground::HeightLayer::kRoad)};
  });
}

Footing footing_of(const scene::Chunk& chunk, const Box2& box, const ground::GradedTerrain& graded) {
  const auto ground = [&](Vec2 p, double) -> std::optional<double> { return land_m(graded, p); };
  const auto wall = [](const buildings::Building& b, Vec2) -> std::optional<double> { return b.bottom_m; };
  return measure_footing(chunk, box, kAllowedGap_m, ground, wall);
}

HeightMeasures measures_of(const scene::Scene& scene, const scene::Chunk& chunk) {
  const Box2 box = scene::box_of(scene.header, chunk.tile);
  const ground::GradedTerrain graded = scene::graded_terrain_of(scene.header, chunk, kFine_m);
  return {.grades = measure_grades(scene.header, chunk),
          .jumps = {},
          .road_faces = graded_road_faces(chunk, box, graded),
          .rises = measure_rises(chunk),
          .lakes = lakes_of(chunk, box, graded),
          .footing = footing_of(chunk, box, graded),
          .clearances = {}};
}

void add_tile(HeightMeasures& sum, const HeightMeasures& tile) {
  sum.grades.length_m += tile.grades.length_m, sum.grades.over_m += tile.grades.over_m;
  sum.rises.streams += tile.rises.streams, sum.rises.rising += tile.rises.rising;
  sum.rises.largest_m = std::max(sum.rises.largest_m, tile.rises.largest_m);
  sum.road_faces = combined(sum.road_faces, tile.road_faces);
  sum.lakes = combined(sum.lakes, tile.lakes);
  sum.footing = combined(sum.footing, tile.footing);
}

}  // namespace

HeightMeasures measure_heights(const scene::Scene& scene, int threads) {
  assert(threads >= 0);
  const auto tiles = for_each_slot<HeightMeasures>(scene.chunks.size(), threads,
                                                   [&](std::size_t i) { return measures_of(scene, scene.chunks[i]); });
  HeightMeasures sum;
  for (const HeightMeasures& tile : tiles) add_tile(sum, tile);
  sum.jumps = measure_jumps(scene);
  sum.clearances = measure_clearances(scene, threads);
  return sum;
}

namespace {

using OrderedJson = nlohmann::ordered_json;

double share(double part, double whole) { return whole > 0 ? part / whole : 0; }

OrderedJson clearances_of(const Clearances& measured) {
  return {{"crossings", measured.crossings},
          {"shortfalls", measured.shortfalls.size()},
          {"shortfalls_over_1_m", measured.count_over(1)},
          {"shortfalls_over_3_m", measured.count_over(3)},
          {"largest_shortfall_m", measured.largest_m()},
          {"contradictions", measured.contradictions.size()}};
}

OrderedJson clearances_of(const ground::ProfileMeasures& planned) {
  return {{"crossings", planned.crossings},
          {"shortfalls", planned.shortfalls},
          {"shortfalls_over_1_m", planned.shortfalls_over_1_m},
          {"shortfalls_over_3_m", planned.shortfalls_over_3_m},
          {"largest_shortfall_m", planned.largest_shortfall_m},
          {"contradictions", planned.contradictions}};
}

}  // namespace

nlohmann::ordered_json heights_json(const HeightReport& heights) {
  const HeightMeasures& m = heights.recipes;
  OrderedJson json = {{"graded_length_m", m.grades.length_m},
                      {"length_over_grade_limit_m", m.grades.over_m},
                      {"share_over_grade_limit", share(m.grades.over_m, m.grades.length_m)},
                      {"largest_height_step_m", m.jumps.largest_m},
                      {"largest_gap_road_to_ground_m", m.road_faces.largest_gap_m},
                      {"watercourses_flowing_uphill", m.rises.rising},
                      {"largest_uphill_rise_m", m.rises.largest_m},
                      {"lakes_not_level", m.lakes.not_level},
                      {"buildings_above_ground", m.footing.floating.size()},
                      {"largest_gap_below_building_m", std::max(0.0, m.footing.largest_gap_m)}};
  json["clearances"] = clearances_of(m.clearances);
  if (heights.planned) json["planned_clearances"] = clearances_of(*heights.planned);
  return json;
}

}  // namespace citykiln::verify
