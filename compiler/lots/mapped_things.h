// Indexes of the mapped things that yards keep clear of.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/polygon.h"
#include "compiler/geometry/vec.h"
#include "compiler/map/features.h"
#include "compiler/roads/junctions/junction.h"
#include "compiler/roads/recipe.h"

namespace citykiln::lots {

/// A strip with round ends: the places within radius_m of the segment from a to b, its axis. Plane metres.
struct Capsule {
  Vec2 a, b;
  double radius_m = 0;
};

/// Capsules with a spatial index, to find the nearest one of a place.
struct Capsules {
  std::vector<Capsule> all;
  BoxGrid grid;
};

/// Returns the index of capsules. O(n).
Capsules index_capsules(std::vector<Capsule> all);

/// Returns the distance from p to the nearest capsule, negative inside of one; search_m if none is nearer.
/// O(capsules near).
double clearance_m(const Capsules& capsules, Vec2 p, double search_m);

/// True if the axis of a capsule enters the polygon, tested at five places, its ends included. The radius does not
/// count. O(capsules near).
bool axis_enters(const Capsules& capsules, const Polygon& polygon);

/// Polygons with an index of their boxes.
struct PolygonIndex {
  std::vector<const Polygon*> all;
  BoxGrid grid;
};

/// True if a polygon contains p. O(vertices near).
bool is_inside_any(const PolygonIndex& polygons, Vec2 p);

/// Polygons of its own with an index of their boxes.
struct OwnPolygons {
  std::vector<Polygon> all;
  BoxGrid grid;
};

/// True if a polygon contains p. O(vertices near).
bool is_inside_any(const OwnPolygons& polygons, Vec2 p);

/// The mapped things on the ground.
struct MappedThings {
  PolygonIndex buildings;  ///< All outlines on the ground, roofs without walls included.
  Capsules walls;          ///< Their edges.
  Capsules roads;          ///< Streets and rails with their pavements.
  Capsules paths;          ///< Paths.
  Capsules drives;         ///< Private ways.
  Capsules barriers;
  Capsules trees;  ///< Trees and tree rows.
  Capsules wires;  ///< Power lines, as wide as trees keep clear: the corridor, and kClearOfWires_m to each side.
  /// About nodes and outlines of junctions of streets: hedges and trees there would hide traffic.
  Capsules junction_zones;
  OwnPolygons corners;  ///< The surfaces of all junctions, and the outer corners of bends.
  Capsules parking;     ///< Borders of car parks.
  PolygonIndex pools;
};

/// Returns the things of a map, which must outlive it. O(n log n).
/// @param private_ways  Sorted.
MappedThings mapped_things(const map::FeatureView& features, std::span<const roads::Road> roads,
                           std::span<const roads::Junction> junctions, std::span<const OsmId> private_ways);

/// The distance of hedges and trees to the node of a junction with a through street, beyond half the width of its
/// widest arm. A through street is of residential or higher class (roads::is_through_street()). The triangle of sight
/// of a crossing in built-up land is about 10 m (RASt 06, 6.3.9.3).
inline constexpr double kSight_m = 10;
/// This distance for a junction without a through street, such as one of service roads. There the junction's
/// outline is larger than the strips of its arms.
inline constexpr double kBesideJunction_m = 4;
/// The distance of hedges and trees to the outline of any junction, which has far corners where arms meet at a small
/// angle.
inline constexpr double kBesideCorner_m = 1;
/// The distance of trees to the corridor of a power line (half of PowerLine::corridor_m to each side of the axis).
inline constexpr double kClearOfWires_m = 3;

}  // namespace citykiln::lots
