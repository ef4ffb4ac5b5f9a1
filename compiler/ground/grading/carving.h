// The carved ground as functions of the place, one a layer: what the terrain becomes where roads and water cut into it.
//
//     terrain ─ ─ ─ ─ ─.                   the land is the terrain, clamped between two slopes that start at the edge
//                   .    ╲ cut             of every road: it is never above the one nor below the other. They are as
//     ▁▁▁▁▁▁▁▁▁▁▁▁▁▁      ╲▁▁▁▁▁▁ road     steep as earth stands, and steeper where they would not meet the terrain
//      fill ╱                              within kCarve_m, or between a higher road and what lies below: up to
//          ╱                               kWallSlope; what is left then is a step at the higher edge: a wall
//
// Under decks the land keeps away from them, over bores it covers them (span_field.h).
// A pure function of roads, waters and terrain within kCarve_m and the roads' breadth, so tiles agree to the bit.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "compiler/geometry/box.h"
#include "compiler/ground/cover/surface_map.h"
#include "compiler/ground/grading/road_field.h"
#include "compiler/ground/grading/span_field.h"
#include "compiler/ground/height_layer.h"
#include "compiler/ground/recipe.h"
#include "compiler/ground/water/water_height.h"
#include "compiler/map/heightfield.h"

namespace citykiln::ground {

/// Slopes of earth beside a road, one up for one and a half along: what stands without help.
inline constexpr double kEarthSlope = 2.0 / 3;

/// Moves, but is not copied: the map refers to what it covers.
struct Carving {
  explicit Carving(map::Heightfield&& terrain);
  Carving(Carving&&) = default;
  Carving& operator=(Carving&&) = default;

  map::Heightfield terrain;
  RoadField roads;
  SpanField decks, bores;
  WaterIndex waters;
  std::vector<Surface> paved, wet;  ///< What roads and junctions cover; what water covers.
  SurfaceMap paved_map;             ///< Tells how far from a rounded corner a place is.
  SurfaceMap wet_map;               ///< Tells how far from the shore a place is.
  BoxGrid shores;                   ///< Where there is water within reach at all.
};

/// What cuts into the terrain near a box.
struct CarvingParts {
  std::span<const roads::Road> roads;     ///< All within kCarve_m of the box, breadth and all.
  std::span<const roads::Strip> streams;  ///< All within kCarve_m and their reach.
  std::span<const Surface> surfaces;      ///< All within kCarve_m; those neither paved nor wet do not matter.
  Box2 box;                               ///< Where heights will be asked for.
  bool has_kerbs = true;                  ///< False where the tolerance sees none.
  std::span<const roads::Road> decks{};   ///< Bridges within kCarve_m of the box, whole.
  std::span<const roads::Road> bores{};   ///< Tunnels likewise.
};
Carving carve(map::Heightfield terrain, const CarvingParts& parts);

/// Of all layers at a place. kCarve_m from roads all are the land's, kCarve_m from water the water's is the land's.
/// O(roads near).
Heights heights_at(const Carving& carving, Vec2 p);

/// The ground at a place, and the terrain that it is carved out of.
struct Sounding {
  Heights heights;
  double terrain_m = 0;
};
Sounding sound(const Carving& carving, Vec2 p);

/// What stands on the ground stands at this height: the land's, on roads that of their kerbs' tops.
double land_m(const Carving& carving, Vec2 p);

/// One a layer, smoothed over a metre or two; where nothing is carved, over the terrain's squares. Unit length.
std::array<Vec3, kHeightLayers> normals_at(const Carving& carving, Vec2 p);

/// False where the carved ground in the box is the terrain.
bool is_carved(const Carving& carving, const Box2& box);

}  // namespace citykiln::ground
