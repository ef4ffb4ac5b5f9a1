// A road in plan: an axis, and the lanes on either side of it. A scene holds those of the ground; what leaves it
// (bridges, tunnels) has its own networks (layers.h), and in a scene is structures/.
#pragma once

#include <vector>

#include "compiler/contract/stable_id.h"
#include "compiler/geometry/polygon.h"
#include "compiler/geometry/profile.h"
#include "compiler/map/features.h"
#include "compiler/map/land_cover_class.h"
#include "compiler/map/lanes/lanes.h"

namespace citykiln::roads {

/// A strip of ground along an axis.
struct Strip {
  ObjectId id;
  Polyline axis;  ///< Plane metres, snapped, at least two points.
  map::LandCoverClass surface{};
  double left_m = 0, right_m = 0;  ///< From the axis to the edges, seen along it; multiples of 2^-10, their sum > 0.
  Profile profile{};               ///< Of its axis, counted from start_along_m.
  double start_along_m = 0;        ///< Of the whole way, before the first point of the axis; a multiple of 2^-10.
  double reach_m = 0;              ///< Of a river with an area: no part of it that it tells the height of lies farther
                                   ///< from its axis; a multiple of 16. 0: it has no area.
  bool operator==(const Strip&) const = default;
};

/// A place where a building lets an edge of the road go no farther out.
struct WidthLimit {
  double at_m = 0;       ///< Along the axis from the beginning of the whole way; a multiple of 1/4 m.
  double half_m = 0;     ///< From the carriageway's middle to the outer edge, at most; a multiple of 1/32 m, > 0.
  bool is_wall = false;  ///< The limit runs straight from the pinch before; else it opens as fast as kTaper lets it.
  bool operator==(const WidthLimit&) const = default;
};

/// What buildings leave of a road's sides; squeeze.h says what gives way. Mostly empty.
struct WidthLimits {
  std::vector<WidthLimit> left, right;  ///< Each sorted, apart, and none less than another allows beside it.
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
  std::vector<map::TrackPoint> points;  ///< Sorted; their vertices are of this axis.
  WidthLimits width_limits;
  Profile profile{};  ///< Of its axis, decided by ground/; empty until then, and for what follows the ground as it is.
  bool operator==(const Road&) const = default;
};

/// From the axis to the kerbs, seen along it.
double left_m(const Road& road);
double right_m(const Road& road);
/// Kerb to kerb.
inline double width_m(const Road& road) { return left_m(road) + right_m(road); }

/// What is raised beyond the left and the right kerb: pavements, cycle tracks, verges.
double raised_left_m(const Road& road);
double raised_right_m(const Road& road);

/// Of that, what lies within the outermost pavement or cycle track: all but verges farther out.
double paved_left_m(const Road& road);
double paved_right_m(const Road& road);

/// How far along the whole way each vertex lies: segments measured to 2^-10 m, so the same in a trimmed run. O(n).
std::vector<double> distances_along(const Road& road);
/// Of any axis of which `start_along_m` lie before its first point.
std::vector<double> distances_along(const Polyline& axis, double start_along_m);

/// No point of the road, kerbs and pavements and all, lies farther from its axis than this, not even a bend's tip.
double max_offset_m(const Road& road);

/// What lies between the kerbs where no building narrows it.
Strip carriageway_of(const Road& road);

}  // namespace citykiln::roads
