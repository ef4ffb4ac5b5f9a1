// The carved ground as functions of the place, one a layer: what the terrain becomes where roads and water cut into it.
//
//     terrain ─ ─ ─ ─ ─.                   the land is the terrain, clamped between two slopes that start at the edge
//                   .    ╲ cut             of every road: it is never above the one nor below the other. They are as
//     ▁▁▁▁▁▁▁▁▁▁▁▁▁▁      ╲▁▁▁▁▁▁ road     steep as earth stands, and steeper where they would not meet the terrain
//      fill ╱                              within kCarve_m. What a lower road cuts away from a higher one's edge stays
//          ╱                               as a step: a retaining wall
//
// A pure function of roads, waters and terrain within kCarve_m and the roads' breadth, so tiles agree to the bit.
#pragma once

#include <span>
#include <vector>

#include "compiler/geometry/box.h"
#include "compiler/ground/height_layer.h"
#include "compiler/ground/recipe.h"
#include "compiler/ground/road_field.h"
#include "compiler/ground/surface_map.h"
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
  std::vector<Surface> paved;  ///< What roads and junctions cover.
  SurfaceMap paved_map;        ///< Of `paved`; tells how far from a rounded corner a place is.
};

/// @param roads      All within kCarve_m of the box, breadth and all.
/// @param paved      The surfaces of roads and junctions near the box.
/// @param has_kerbs  False where the tolerance sees none.
Carving carve(map::Heightfield terrain, std::span<const roads::Road> roads, std::vector<Surface> paved, const Box2& box,
              bool has_kerbs);

/// Of all layers at a place. Far from roads all are the land's; far from water the water's is the land's. O(roads
/// near).
Heights heights_at(const Carving& carving, Vec2 p);

/// What stands on the ground stands at this height: the land's, on roads that of their kerbs' tops.
double land_m(const Carving& carving, Vec2 p);

/// Of one layer, smoothed over a metre or two; where nothing is carved, over the terrain's squares. Unit length.
Vec3 normal_at(const Carving& carving, Vec2 p, HeightLayer layer);

/// True where nothing near the box is carved and the terrain in it is level.
bool is_level(const Carving& carving, const Box2& box);

}  // namespace citykiln::ground
