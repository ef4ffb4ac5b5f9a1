// The graded terrain: the ground after roads and water have cut into the terrain and filled it. Its heights are four
// functions of the place, one per height layer: land, roads at the top of their kerbs, carriageways and water
// (height_layer.h). All four exist everywhere; each face of the ground takes the height of one.
//
//     terrain ─ ─ ─ ─ ─.
//                   .    ╲ cut
//     ▁▁▁▁▁▁▁▁▁▁▁▁▁▁      ╲▁▁▁▁▁▁ road
//      fill ╱
//          ╱
//
// - The land is the terrain, clamped at each place. From the edge of every road one slope rises outwards and one falls
//   outwards. The land is never above the rising slope nor below the falling one.
// - The slopes have kEarthSlope. They are steeper where they would not meet the terrain within kGrading_m (16 m).
// - A bank that carries a higher road, and that ends at a lower road or water, may also be steeper: up to 1.5 up for 1
//   along. If even that is too flat, the rest of the difference is a vertical step at the edge of the higher
//   road: a wall.
// - Cuttings that lead down to tunnels (roads::Cutting) have walls at the edges of their roads.
// - Below the deck of a bridge the land leaves the clearance free. Over a bored tunnel it covers the roof
//   (span_influence.h).
// - Retaining walls, cliffs and dykes change the terrain before that (landforms). Across a step in the land, the slopes
//   from roads and shores may rise or fall by the step's height more. Piers raise the land after it, above water.
//
// A height depends only on the terrain, on roads, water, bridges and tunnels whose edges are within kGrading_m of the
// place, and on landforms whose edges are within kLandformReach_m. So tiles that are generated separately have equal
// heights at their common border, bit for bit.
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
#include "compiler/ground/landforms/landform_index.h"
#include "compiler/ground/recipe.h"
#include "compiler/ground/water/water_height.h"
#include "compiler/map/plane/heightfield.h"
#include "compiler/roads/pieces/dropped_kerbs.h"

namespace citykiln::ground {

/// The slope at which earth beside a road stands without support: 1 up for 1.5 along.
inline constexpr double kEarthSlope = 2.0 / 3;

/// The terrain of a box with all data that grade it. Can be moved but not copied: the indices refer to the polygons.
struct GradedTerrain {
  /// A terrain that nothing grades yet; grade_terrain() fills the other members.
  explicit GradedTerrain(map::Heightfield&& terrain);
  GradedTerrain(GradedTerrain&&) = default;
  GradedTerrain& operator=(GradedTerrain&&) = default;

  map::Heightfield terrain;                  ///< The terrain before grading.
  RoadInfluenceIndex roads;                  ///< The roads on the ground.
  roads::KerbRampIndex kerb_ramps;           ///< Where their kerbs are lower.
  SpanInfluenceIndex decks, bores;           ///< Bridges; bored tunnels.
  LandformIndex landforms;                   ///< Retaining walls, cliffs, dykes, piers.
  WaterIndex waters;                         ///< The heights of water.
  std::vector<LandCoverPolygon> paved, wet;  ///< Polygons of roads and junctions; polygons of water.
  LandCoverIndex paved_index;                ///< For the distance to rounded corners of roads.
  LandCoverIndex wet_index;                  ///< For the distance to the shore.
  BoxGrid shores;                            ///< Boxes of water, widened by kGrading_m.
};

/// The recipes (planned objects, without triangles) that grade the terrain in a box, of a map or a tile. A Strip is a
/// watercourse: an axis with a width on both sides. The polygons of `streams` count as water, whether
/// `surfaces` contains them or not.
struct GradingInputs {
  std::span<const roads::Road> roads;     ///< All roads whose edges are within kGrading_m of the box.
  std::span<const roads::Strip> streams;  ///< All streams whose water is within kGrading_m of it.
  /// All polygons within kGrading_m of the box whose height layer is a road's, a carriageway's or water. Further
  /// polygons do no harm.
  std::span<const LandCoverPolygon> surfaces;
  Box2 box;                              ///< The box in which heights can be queried.
  bool has_kerbs = true;                 ///< False for tolerances at which kerbs are left out.
  std::span<const roads::Road> decks{};  ///< Bridges within kGrading_m of the box, whole.
  std::span<const roads::Road> bores{};  ///< Bored tunnels within kGrading_m of the box, whole.
  /// All landforms within kLandformReach_m of the box, sorted by id.
  std::span<const Landform> landforms{};
  std::span<const roads::KerbRamp> kerb_ramps{};  ///< Where kerbs are lower: all that touch the box.
};
/// Indexes all data that grade a terrain. Heights are computed later, by heights_at().
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

/// Returns the heights of all layers at p, which must lie in the box; layer_height_m() reads one of them. Farther than
/// kGrading_m from roads and water, all layers have the land's height. O(roads near).
Heights heights_at(const GradedTerrain& graded, Vec2 p);

/// Heights at a place.
struct HeightSample {
  Heights heights;       ///< One per layer.
  double terrain_m = 0;  ///< The height of the terrain before grading.
};
/// Returns heights_at() together with the terrain's height.
HeightSample sample_heights(const GradedTerrain& graded, Vec2 p);

/// Returns the height of HeightLayer::kLand at p, on which objects stand. On a road it is the height of the kerbs'
/// tops.
double land_m(const GradedTerrain& graded, Vec2 p);

/// Returns the height of the ground below a wall at p: that of a road in a cutting if p is on it, and else land_m().
double wall_ground_m(const GradedTerrain& graded, Vec2 p);

/// Returns one normal per layer, of unit length. A normal of a layer that differs from the terrain comes from heights
/// 1 m to each side of p. The others are normals of the terrain, smoothed over its grid squares.
std::array<Vec3, kHeightLayers> normals_at(const GradedTerrain& graded, Vec2 p);

/// True if a road, a structure, water or a landform may change the terrain in the box.
bool has_grading(const GradedTerrain& graded, const Box2& box);

}  // namespace citykiln::ground
