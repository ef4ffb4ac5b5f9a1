// A road at ground level: an axis, and the lanes on either side of it. What leaves the ground (bridges, tunnels) is
// structures/.
#pragma once

#include <vector>

#include "compiler/contract/stable_id.h"
#include "compiler/geometry/polygon.h"
#include "compiler/map/features.h"
#include "compiler/map/lanes.h"
#include "compiler/map/surface_class.h"

namespace citykiln::roads {

/// A strip of ground along an axis.
struct Strip {
  ObjectId id;
  Polyline axis;  ///< Plane metres, snapped, at least two points.
  map::SurfaceClass surface{};
  double left_m = 0, right_m = 0;  ///< From the axis to the edges, seen along it; multiples of 2^-10, their sum > 0.
  bool operator==(const Strip&) const = default;
};

struct Road {
  ObjectId id;
  Polyline axis;  ///< Plane metres, snapped, at least two points.
  map::SurfaceClass surface{};
  map::CrossSection section;
  map::DrivingSide side{};
  bool is_lit = false, is_link = false, is_roundabout = false;
  double passed_m = 0;                  ///< Of the whole way, before the first point of the axis; a multiple of 2^-10.
  std::vector<map::TrackPoint> points;  ///< Sorted; their vertices are of this axis.
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

/// No point of the road, kerbs and pavements and all, lies farther from its axis than this, not even a bend's tip.
double breadth_m(const Road& road);

/// What lies between the kerbs.
Strip carriageway_of(const Road& road);

}  // namespace citykiln::roads
