// Generates the features of a yard from its recipe: areas, barriers and plants.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/lots/mapped_things.h"
#include "compiler/lots/recipe.h"
#include "compiler/lots/yard_rules.h"
#include "compiler/map/features.h"

namespace citykiln::lots {

/// The width of a path for one person, of usual slabs, and of a drive, the lane of a garage (2.75 m in the German
/// regulation GaStellV).
inline constexpr double kYardPath_m = 1.25, kDriveWidth_m = 2.75;
/// A front yard with a smaller setback gets no area of its own, unless it is the paved one of a town.
inline constexpr double kLeastSeen_m = 0.3125;
/// Barriers along a street stand this far from the pavement's outer edge, on the side of the lot.
inline constexpr double kInsidePavement_m = 0.375;
/// The name that rows of bays have in pitches/pitches.inc.
inline constexpr const char* kBays = "parking";

/// Returns the middle lines of path and drive with half their widths, in the plane, in the order of yard.strips.
std::vector<Capsule> openings_of(const Yard& yard);

/// A segment of a lot's border: a part of an edge of the outer ring, at most 0.5 m long. Plane metres.
struct BorderSegment {
  Vec2 from, to;
  std::uint32_t edge = 0;  ///< Edge i joins points i and i + 1 of the ring.
};
/// Returns the segments around a ring, from its first point on. Each edge is divided evenly. O(length).
std::vector<BorderSegment> border_segments(const Ring& ring);

/// Returns the distance of a barrier from the border of its lot, on the inside.
double inset_m(BorderPlace place);
/// Returns the axis of the barrier on a run of segments, offset to their left by its inset. Corners of the ring are
/// mitred, by at most twice the inset. Points are multiples of map::kMapStep_m.
/// @param segments  The segments of a counter-clockwise ring.
/// @param run       1 to segments.size() segments, the first of which exists.
Polyline border_line(std::span<const BorderSegment> segments, const BorderRun& run);

/// A tree or shrub of a yard.
struct YardPlant {
  Vec2 at;  ///< In the plane, a multiple of kYardStep_m.
  bool is_shrub = false;
  double height_m = 0;  ///< A multiple of kYardStep_m; 0: the stage of plants decides.
};

/// Returns the plants that the seed picks for a yard, whatever else stands there:
///
/// - at most one in each square of 4 m of a grid of the plane, moved by up to 1.2 m in x and y; two are at least 1.4 m
///   apart;
/// - as many on average as the rule says, on soft ground (is_planted(), yard_rules.h);
/// - 0.75 m or more inside the border.
///
/// In the order of squares, row by row from the south. O(area of the yard's box).
std::vector<YardPlant> plants_drawn(const Yard& yard, const YardRule& rule, std::uint64_t seed);

/// The features of a yard. Each has the id of the building, with a part from kFirstDerivedPart on
/// (contract/derived_id.h); ids are unique within one list.
struct DrawnYard {
  std::vector<map::AreaFeature> areas;  ///< The first is the whole lot; the others lie on top of it.
  std::vector<map::SportsArea> bays;    ///< Rows of bays for cars: each has the id of the area it lies on.
  std::vector<map::Barrier> barriers;
  std::vector<map::PointFeature> plants;
};

/// Returns the features of a yard; none for a kind without a rule or an empty outer ring. Depends on nothing else, so
/// that a yard can be generated again from a manifest. Runs out of range are left out. Bit-identical on all machines.
/// Cost: O(area of its box), which readers and planners limit by kLargestYard_m.
DrawnYard draw_yard(const Yard& yard, std::uint64_t seed);

}  // namespace citykiln::lots
