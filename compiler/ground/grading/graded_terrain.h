// The graded terrain: heights as functions of the place, one per height layer, where roads and water cut into the
// terrain.
//
//     terrain ─ ─ ─ ─ ─.                   the land is the terrain, clamped between two slopes that start at the edge
//                   .    ╲ cut             of every road: it is never above the one nor below the other. They are as
//     ▁▁▁▁▁▁▁▁▁▁▁▁▁▁      ╲▁▁▁▁▁▁ road     steep as earth stands, and steeper where they would not meet the terrain
//      fill ╱                              within kGrading_m, or between a higher road and what lies below: up to
//          ╱                               kWallSlope; what is left then is a step at the higher edge: a wall
//
// Land is below decks and above bores (span_influence.h). Heights depend on recipes and terrain within kGrading_m and
// the roads' widths, so tiles agree bit for bit.
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <iterator>
#include <span>
#include <utility>
#include <vector>

#include "compiler/geometry/box.h"
#include "compiler/ground/cover/land_cover_index.h"
#include "compiler/ground/grading/road_influence.h"
#include "compiler/ground/grading/span_influence.h"
#include "compiler/ground/height_layer.h"
#include "compiler/ground/recipe.h"
#include "compiler/ground/water/water_height.h"
#include "compiler/map/plane/heightfield.h"

namespace citykiln::ground {

/// The slope at which earth beside a road stands without support: 1 up for 1.5 along.
inline constexpr double kEarthSlope = 2.0 / 3;

/// The terrain of a box with all data that grade it. Can be moved but not copied: the indices refer to the polygons.
struct GradedTerrain {
  explicit GradedTerrain(map::Heightfield&& terrain);
  GradedTerrain(GradedTerrain&&) = default;
  GradedTerrain& operator=(GradedTerrain&&) = default;

  map::Heightfield terrain;
  RoadInfluenceIndex roads;
  SpanInfluenceIndex decks, bores;
  WaterIndex waters;
  std::vector<LandCoverPolygon> paved, wet;  ///< Polygons of roads and junctions; polygons of water.
  LandCoverIndex paved_index;                ///< For the distance to rounded corners of roads.
  LandCoverIndex wet_index;                  ///< For the distance to the shore.
  BoxGrid shores;                            ///< Boxes of water, widened by kGrading_m.
};

/// The recipes that grade the terrain in a box, of a map or a tile. The polygons of `streams` count as water, whether
/// `surfaces` contains them or not.
struct GradingInputs {
  std::span<const roads::Road> roads;          ///< All roads whose edges are within kGrading_m of the box.
  std::span<const roads::Strip> streams;       ///< All streams whose water is within kGrading_m of it.
  std::span<const LandCoverPolygon> surfaces;  ///< All polygons within kGrading_m on road and water layers, or more.
  Box2 box;                                    ///< The box in which heights can be queried.
  bool has_kerbs = true;                       ///< False for tolerances at which kerbs are left out.
  std::span<const roads::Road> decks{};        ///< Bridges within kGrading_m of the box, whole.
  std::span<const roads::Road> bores{};        ///< Bored tunnels within kGrading_m of the box, whole.
};
GradedTerrain grade_terrain(map::Heightfield terrain, const GradingInputs& parts);

/// Grades the terrain of a map or a tile from its recipes: every bridge is a deck, every tunnel with `is_bored` a bore.
template <std::derived_from<roads::Road> Span>
GradedTerrain grade_terrain(map::Heightfield terrain, GradingInputs parts, std::span<const Span> bridges,
                            std::span<const Span> tunnels) {
  const std::vector<roads::Road> decks(bridges.begin(), bridges.end());
  std::vector<roads::Road> bores;
  std::ranges::copy_if(tunnels, std::back_inserter(bores), &Span::is_bored);
  parts.decks = decks, parts.bores = bores;
  return grade_terrain(std::move(terrain), parts);
}

/// Returns the heights of all layers at p, which must lie in the box. Farther than kGrading_m from roads and water, all
/// layers have the land's height. O(roads near).
Heights heights_at(const GradedTerrain& graded, Vec2 p);

/// Heights of all layers at a place, and the height of the terrain before grading.
struct HeightSample {
  Heights heights;
  double terrain_m = 0;
};
HeightSample sample_heights(const GradedTerrain& graded, Vec2 p);

/// Returns the height at which objects stand on the ground: the height of the land; on roads the height of the kerbs'
/// tops.
double land_m(const GradedTerrain& graded, Vec2 p);

/// Returns one normal per layer, of unit length, smoothed over 2 · kNormalStep_m. Without grading these are the
/// terrain's own normals, smoothed over its grid squares.
std::array<Vec3, kHeightLayers> normals_at(const GradedTerrain& graded, Vec2 p);

/// True if a road, a structure or water may change the terrain in the box.
bool has_grading(const GradedTerrain& graded, const Box2& box);

}  // namespace citykiln::ground
