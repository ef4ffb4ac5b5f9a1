// Road recipes: an axis and the lanes on either side of it. Bridges and tunnels are structures (structures/recipe.h).
// The whole way is the OSM way of which the axis may be a part; "along" means distance from its first point.
#pragma once

#include <vector>

#include "compiler/contract/stable_id.h"
#include "compiler/geometry/polygon.h"
#include "compiler/geometry/profile.h"
#include "compiler/map/cross_section.h"
#include "compiler/map/features.h"
#include "compiler/map/land_cover_class.h"

namespace citykiln::roads {

/// A strip of ground along an axis, such as a watercourse.
struct Strip {
  ObjectId id;
  Polyline axis;  ///< Plane metres, snapped, at least two points.
  map::LandCoverClass surface{};
  double left_m = 0, right_m = 0;  ///< From the axis to the edges, seen along it; multiples of 2^-10, their sum > 0.
  Profile profile{};               ///< Heights along the axis, by distance from the start of the whole way.
  double start_along_m = 0;        ///< Distance of the axis' first point along the whole way; a multiple of 2^-10.
  double influence_radius_m = 0;   ///< Rivers with an area: the greatest distance from the axis at which the profile
                                   ///< gives heights; a multiple of 16. 0 for all others.
  bool operator==(const Strip&) const = default;
};

/// The largest distance of the road's edge from its middle that buildings allow, on one side, at one distance along the
/// way.
struct WidthLimit {
  double at_m = 0;       ///< Distance along the whole way; a multiple of 1/4 m.
  double half_m = 0;     ///< Largest distance of the edge from the carriageway's middle; a multiple of 1/32 m, > 0.
  bool is_wall = false;  ///< True if the limit is a straight line from the previous point; false if it widens as fast
                         ///< as kTaper allows in between.
  bool operator==(const WidthLimit&) const = default;
};

/// The width limits of both sides of a road; mostly empty. narrowed_section.h applies them to lanes.
struct WidthLimits {
  std::vector<WidthLimit> left, right;  ///< Each sorted by at_m; limits differ by at most kTaper times the distance.
  bool is_empty() const { return left.empty() && right.empty(); }
  bool operator==(const WidthLimits&) const = default;
};

/// A part of a road that leads down to a tunnel between retaining walls: the land beside it is not cut to slopes.
struct Cutting {
  double from_m = 0;  ///< Distance along the whole way; a multiple of 1/4 m. 0: it begins before the way does.
  double to_m = 0;    ///< A multiple of 1/4 m, > from_m; beyond the way's end if it goes on there.
  bool operator==(const Cutting&) const = default;
};

/// A road, path or railway on the ground.
struct Road {
  ObjectId id;
  Polyline axis;  ///< Plane metres, snapped, at least two points.
  map::LandCoverClass surface{};
  map::CrossSection section;
  map::DrivingSide side{};
  bool is_lit = false, is_link = false, is_roundabout = false;
  double start_along_m = 0;  ///< Distance of the axis' first point along the whole way; multiple of 2^-10.
  /// Marked nodes such as crossings, sorted; TrackPoint::vertex is an index into this axis.
  std::vector<map::TrackPoint> points;
  WidthLimits width_limits;
  Profile profile{};  ///< Heights along the axis. Empty in a RoadPlan, and for roads that lie on the terrain.
  std::vector<Cutting> cuttings{};  ///< Sorted, disjoint; mostly none. Set with the profile.
  double riser_m = 0;          ///< The height of a step of stairs with a tagged number of steps; a multiple of 2^-10.
  std::uint8_t handrails = 0;  ///< map::Handrail bits of stairs.
  map::CountryGroup country{};
  Assumptions assumed = kNoAssumptions;  ///< The assumptions made of it.
  std::uint8_t assumed_sides = 0;        ///< Sides on which a pavement or verge is assumed: bits of map::RoadSide.
  std::uint8_t kerb_parking = 0;         ///< Sides at whose kerbs cars may park (kerb_parking_of()): bits of RoadSide.
  bool operator==(const Road&) const = default;
};

/// The distance from the axis to the left or right kerb, seen along the axis; at the way's first point where the axis
/// drifts (placement=transition).
double left_m(const Road& road);
double right_m(const Road& road);
/// The distance by which the kerbs lie farther left of the axis at a distance along the whole way than at its first
/// point.
inline double drift_m(const Road& road, double along_m) { return road.section.axis_drift * along_m; }
/// The largest distance from the axis to the left or right kerb along the way, or more where the axis drifts.
double widest_left_m(const Road& road);
double widest_right_m(const Road& road);
/// The width from kerb to kerb.
inline double width_m(const Road& road) { return left_m(road) + right_m(road); }

/// The width of the raised lanes beyond each kerb: pavements, cycle tracks, verges.
double raised_left_m(const Road& road);
double raised_right_m(const Road& road);

/// The part of the raised width up to the outermost pavement or cycle track, without verges outside it.
double paved_left_m(const Road& road);
double paved_right_m(const Road& road);

/// The distance of each vertex of the axis along the whole way. Lengths of segments are rounded to 2^-10 m, so that a
/// trimmed road has the same distances as the whole one. O(n).
std::vector<double> distances_along(const Road& road);
/// The distance of each vertex of any axis along the whole way.
/// @param start_along_m  Length of the way before the axis begins.
std::vector<double> distances_along(const Polyline& axis, double start_along_m);

/// The priority of the road's class.
inline int priority_of(const Road& road) { return map::values_of(road.surface).priority; }

/// The largest distance of any point of the road from its axis, pavements and tips of mitres included.
double max_offset_m(const Road& road);

/// The strip of ground between the kerbs, without width limits. The axis does not drift.
Strip carriageway_of(const Road& road);

}  // namespace citykiln::roads
