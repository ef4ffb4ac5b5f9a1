// A road in plan: an axis and the lanes on either side of it. Scenes hold the roads on the ground; bridges and tunnels
// are structures there, and junctions/layers.h plans their networks.
#pragma once

#include <vector>

#include "compiler/contract/stable_id.h"
#include "compiler/geometry/polygon.h"
#include "compiler/geometry/profile.h"
#include "compiler/map/cross_section.h"
#include "compiler/map/features.h"
#include "compiler/map/land_cover_class.h"

namespace citykiln::roads {

/// A strip of ground along an axis.
struct Strip {
  ObjectId id;
  Polyline axis;  ///< Plane metres, snapped, at least two points.
  map::LandCoverClass surface{};
  double left_m = 0, right_m = 0;  ///< From the axis to the edges, seen along it; multiples of 2^-10, their sum > 0.
  Profile profile{};               ///< Heights along the axis, by distance from the start of the whole way.
  double start_along_m = 0;        ///< Of the whole way, before the first point of the axis; a multiple of 2^-10.
  double reach_m = 0;              ///< Rivers with an area: the greatest distance from the axis at which the profile
                                   ///< gives heights; a multiple of 16. 0 for all others.
  bool operator==(const Strip&) const = default;
};

/// A point of one side where a building limits how far out the road's edge may lie.
struct WidthLimit {
  double at_m = 0;       ///< Distance along the whole way; a multiple of 1/4 m.
  double half_m = 0;     ///< From the middle of the carriageway to the outer edge, at most; a multiple of 1/32 m, > 0.
  bool is_wall = false;  ///< The limit runs straight from the previous point; else it opens by kTaper in between.
  bool operator==(const WidthLimit&) const = default;
};

/// The width limits of a road's two sides; mostly empty. narrowed_section.h applies them to lanes.
struct WidthLimits {
  std::vector<WidthLimit> left, right;  ///< Each sorted by at_m; no limit exceeds what its neighbours allow.
  bool is_empty() const { return left.empty() && right.empty(); }
  bool operator==(const WidthLimits&) const = default;
};

struct Road {
  ObjectId id;
  Polyline axis;  ///< Plane metres, snapped, at least two points.
  map::LandCoverClass surface{};
  map::CrossSection section;
  map::DrivingSide side{};
  bool is_lit = false, is_link = false, is_roundabout = false;
  double start_along_m = 0;             ///< Of the whole way, before the first point of the axis; a multiple of 2^-10.
  std::vector<map::TrackPoint> points;  ///< Sorted; vertices index this axis.
  WidthLimits width_limits;
  Profile profile{};  ///< Heights along the axis, set by ground::plan_profiles(); empty before, and for roads on
                      ///< unaltered terrain.
  bool operator==(const Road&) const = default;
};

/// The distance from the axis to the kerbs, seen along it.
double left_m(const Road& road);
double right_m(const Road& road);
/// The width from kerb to kerb.
inline double width_m(const Road& road) { return left_m(road) + right_m(road); }

/// The width of the raised lanes beyond each kerb: pavements, cycle tracks, verges.
double raised_left_m(const Road& road);
double raised_right_m(const Road& road);

/// The part of the raised width up to the outermost pavement or cycle track, without verges outside it.
double paved_left_m(const Road& road);
double paved_right_m(const Road& road);

/// The distance of each vertex along the whole way. Segments are measured to 2^-10 m, so a trimmed part has the same
/// distances. O(n).
std::vector<double> distances_along(const Road& road);
/// The same for any axis. @param start_along_m  Length of the way before the axis begins.
std::vector<double> distances_along(const Polyline& axis, double start_along_m);

/// The priority of the road's class.
inline int priority_of(const Road& road) { return map::values_of(road.surface).priority; }

/// No point of the road, pavements included, lies farther from its axis than this, not even the tip of a mitre.
double max_offset_m(const Road& road);

/// The strip between the kerbs, without width limits.
Strip carriageway_of(const Road& road);

}  // namespace citykiln::roads
