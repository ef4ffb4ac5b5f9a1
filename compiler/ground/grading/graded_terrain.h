// The graded terrain as functions of the place, one a layer: what the terrain becomes where roads and water cut into
// it.
//
//     terrain ─ ─ ─ ─ ─.                   the land is the terrain, clamped between two slopes that start at the edge
//                   .    ╲ cut             of every road: it is never above the one nor below the other. They are as
//     ▁▁▁▁▁▁▁▁▁▁▁▁▁▁      ╲▁▁▁▁▁▁ road     steep as earth stands, and steeper where they would not meet the terrain
//      fill ╱                              within kGrading_m, or between a higher road and what lies below: up to
//          ╱                               kWallSlope; what is left then is a step at the higher edge: a wall
//
// Under decks the land keeps away from them, over bores it covers them (span_field.h).
// A pure function of roads, waters and terrain within kGrading_m and the roads' breadth, so tiles agree to the bit.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "compiler/geometry/box.h"
#include "compiler/ground/cover/land_cover_index.h"
#include "compiler/ground/grading/road_influence.h"
#include "compiler/ground/grading/span_influence.h"
#include "compiler/ground/height_layer.h"
#include "compiler/ground/recipe.h"
#include "compiler/ground/water/water_height.h"
#include "compiler/map/heightfield.h"

namespace citykiln::ground {

/// Slopes of earth beside a road, one up for one and a half along: what stands without help.
inline constexpr double kEarthSlope = 2.0 / 3;

/// Moves, but is not copied: the map refers to what it covers.
struct GradedTerrain {
  explicit GradedTerrain(map::Heightfield&& terrain);
  GradedTerrain(GradedTerrain&&) = default;
  GradedTerrain& operator=(GradedTerrain&&) = default;

  map::Heightfield terrain;
  RoadInfluenceIndex roads;
  SpanInfluenceIndex decks, bores;
  WaterIndex waters;
  std::vector<LandCoverPolygon> paved, wet;  ///< What roads and junctions cover; what water covers.
  LandCoverIndex paved_index;                ///< Tells how far from a rounded corner a place is.
  LandCoverIndex wet_index;                  ///< Tells how far from the shore a place is.
  BoxGrid shores;                            ///< Where there is water within reach at all.
};

/// What cuts into the terrain near a box.
struct GradingInputs {
  std::span<const roads::Road> roads;          ///< All within kGrading_m of the box, breadth and all.
  std::span<const roads::Strip> streams;       ///< All within kGrading_m and their reach.
  std::span<const LandCoverPolygon> surfaces;  ///< All within kGrading_m; those neither paved nor wet do not matter.
  Box2 box;                                    ///< Where heights will be asked for.
  bool has_kerbs = true;                       ///< False where the tolerance sees none.
  std::span<const roads::Road> decks{};        ///< Bridges within kGrading_m of the box, whole.
  std::span<const roads::Road> bores{};        ///< Tunnels likewise.
};
GradedTerrain grade_terrain(map::Heightfield terrain, const GradingInputs& parts);

/// Of all layers at a place. kGrading_m from roads all are the land's, kGrading_m from water the water's is the land's.
/// O(roads near).
Heights heights_at(const GradedTerrain& graded, Vec2 p);

/// The ground at a place, and the terrain that it is carved out of.
struct HeightSample {
  Heights heights;
  double terrain_m = 0;
};
HeightSample sample_heights(const GradedTerrain& graded, Vec2 p);

/// What stands on the ground stands at this height: the land's, on roads that of their kerbs' tops.
double land_m(const GradedTerrain& graded, Vec2 p);

/// One a layer, smoothed over a metre or two; where nothing is carved, over the terrain's squares. Unit length.
std::array<Vec3, kHeightLayers> normals_at(const GradedTerrain& graded, Vec2 p);

/// False where the graded terrain in the box is the terrain.
bool has_grading(const GradedTerrain& graded, const Box2& box);

}  // namespace citykiln::ground
