// Recipes of the ground, plain data from which its mesh is generated later: land cover polygons. A strip is the polygon
// of a road or watercourse: an axis with a width on each side. map::Heightfield holds the heights of the terrain.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "compiler/contract/stable_id.h"
#include "compiler/geometry/polygon.h"
#include "compiler/map/land_cover_class.h"

namespace citykiln::ground {

/// A part of the plane with one land cover class: all places at which the winding numbers of the rings add up to more
/// than zero. Rings may overlap and cross.
struct LandCoverPolygon {
  ObjectId id;
  map::LandCoverClass surface{};
  std::uint32_t area_m2 = 0;  ///< Area before trimming, rounded; strips and junctions have a constant below. If two
                              ///< polygons have one priority, the smaller is on top, then the lower id.
  std::vector<Ring> rings;    ///< Plane metres, snapped.
  std::uint32_t piece = 0;    ///< Number of a road's piece (roads/pieces): 1, 2 … along it; 0 for other polygons.
  std::optional<double> level_m{};  ///< Plane height of standing water, a multiple of kProfileQuantum_m.
  bool is_graded = false;           ///< True if it belongs to a road with a profile, which decides its height.
  /// The highest priority, raised ones included, of the larger areas that it lies in; 0 if none is above its class's.
  std::uint8_t raised_priority = 0;
  std::uint8_t row_heading = 0;  ///< The direction of a field's rows (map/row_direction.h).
  bool operator==(const LandCoverPolygon&) const = default;
};

/// Returns the priority that decides which of overlapping polygons is on top: the larger of its class's and
/// raised_priority.
inline int priority_of(const LandCoverPolygon& polygon) {
  return std::max(map::values_of(polygon.surface).priority, polygon.raised_priority);
}

/// True for the surfaces of yards, which are assumed.
inline bool is_yard(const LandCoverPolygon& polygon) {
  return polygon.surface >= map::LandCoverClass::kLawn && polygon.surface <= map::LandCoverClass::kAsphaltDrive;
}

/// Values of area_m2 for strips of roads and for junctions. They put strips above areas of their priority, and
/// junctions above strips; a junction through which a road's lanes run (kPassedJunctionArea_m2) lies below strips.
inline constexpr std::uint32_t kJunctionArea_m2 = 0, kStripArea_m2 = 1, kPassedJunctionArea_m2 = 2;

/// The largest distance between stations, the places along a road at which its height is decided. Lines across the road
/// at stations are edges of the ground. It is short enough for the shortest vertical curves of streets.
inline constexpr double kStation_m = 16;

/// True if `a` lies on top of `b`: a strict total order for different ids, classes and pieces.
bool covers(const LandCoverPolygon& a, const LandCoverPolygon& b);

/// Returns the box of all rings; empty if there are none.
Box2 box_of(const LandCoverPolygon& polygon);

/// Returns the sum of the rings' winding numbers about p. The polygon covers p if it is above zero.
int winding_number(const LandCoverPolygon& polygon, Vec2 p);

}  // namespace citykiln::ground
