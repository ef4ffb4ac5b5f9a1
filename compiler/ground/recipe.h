// The ground's recipes: what covers it. How high the terrain is says map::Heightfield.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "compiler/contract/stable_id.h"
#include "compiler/geometry/polygon.h"
#include "compiler/map/land_cover_class.h"

namespace citykiln::ground {

/// A part of the plane with one land cover class: every place at which the winding numbers of the rings add up to more
/// than zero. Rings may overlap and cross.
struct LandCoverPolygon {
  ObjectId id;
  map::LandCoverClass surface{};
  std::uint32_t area_m2 = 0;  ///< Area before trimming, rounded; a constant below for strips and junctions. Of two
                              ///< polygons of one priority the smaller is on top, then the lower id.
  std::vector<Ring> rings;    ///< Plane metres, snapped.
  std::uint32_t piece = 0;    ///< Numbers the pieces that a road is baked in: 1, 2 … along it; 0 otherwise.
  std::optional<double> level_m{};  ///< Of standing water: plane height, a multiple of kProfileQuantum_m.
  bool is_graded = false;           ///< Belongs to a road with a profile: lies on it, whatever its class.
  bool operator==(const LandCoverPolygon&) const = default;
};

/// Strips lie over areas of their priority and junctions over strips, except junctions that a road passes through.
inline constexpr std::uint32_t kJunctionArea_m2 = 0, kStripArea_m2 = 1, kPassedJunctionArea_m2 = 2;

/// Stations along a road are at most this far apart: heights are decided there, and lines across the road carry them to
/// the ground beside it. Short enough for the shortest vertical curves of streets.
inline constexpr double kStation_m = 16;

/// Returns whether `a` lies on top of `b`: a strict total order for different ids, classes and pieces.
bool covers(const LandCoverPolygon& a, const LandCoverPolygon& b);

/// Returns the box of all rings; empty without any.
Box2 box_of(const LandCoverPolygon& polygon);

/// Returns the sum of the rings' winding numbers about p; the polygon covers p where it is above zero.
int winding_number(const LandCoverPolygon& polygon, Vec2 p);

}  // namespace citykiln::ground
