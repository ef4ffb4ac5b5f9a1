// Fields that are mapped one by one, joined into the land that they are parts of, for the chart of assumptions.
//
//     +---+--+-----+       +----------+
//     | a |b | c   |       | land     |    fields of one class that share a border are one land; the strips between
//     +---+--+-----+  -->  |          |    them, up to kFieldGap_m wide, are parts of it
//     |  d   | e   |       |          |
//     +------+-----+       +----------+
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "compiler/geometry/box_grid.h"
#include "compiler/map/features.h"

namespace citykiln::charts {

/// Fields share a border where they are this near to each other, in metres: a hedge, a ditch or a balk lies between
/// them.
inline constexpr double kFieldGap_m = 8;

/// A straight piece of a border, plane metres.
using BorderPiece = std::pair<Vec2, Vec2>;

/// Returns the pieces of outlines that lie within `gap_m` of another of the polygons; a border that two of them share
/// is there twice. O(length · edges near).
std::vector<BorderPiece> inner_borders(std::span<const Polygon* const> polygons, double gap_m);

/// Neighbouring fields of one class.
struct Land {
  ObjectId id;  ///< The lowest id of its fields.
  map::LandCoverClass surface{};
  std::vector<const map::AreaFeature*> fields;  ///< At least two.
  std::vector<Polygon> outlines;                ///< The land, mostly one polygon.
  std::vector<BorderPiece> borders;             ///< The borders that its fields share.
};

/// Returns the lands of a map, sorted by id: farmland and meadows whose tags name no plants, whole within the extent.
/// Neighbours share at least 16 m of border, and have their middles in one square of kLandSquare_m: land is not as
/// large as a country. Refers to the areas of the map, which must outlive it.
std::vector<Land> lands_of(const map::Features& features);

/// The side of the squares in which fields are joined, in metres.
inline constexpr double kLandSquare_m = 4096;

/// Replaces the fields of each land by the land, and leaves out barriers and rows of trees: these stand on borders.
void join_fields(map::Features& features);

/// The lines of a map that divide fields whatever is assumed: ways and watercourses on the ground.
struct DividingWays {
  std::vector<Polyline> all;
  std::vector<BorderPiece> pieces;
  BoxGrid grid;  ///< The boxes of `pieces`.
};
DividingWays dividing_ways(const map::Features& features);

/// Returns the parts of a field between the lines that divide it, without those of less than kLeastField_m2 or a
/// twelfth of the field: corners that a way cuts off.
std::vector<Polygon> parts_between(const Polygon& field, const DividingWays& ways);

/// Smaller pieces are no fields, in square metres.
inline constexpr double kLeastField_m2 = 500;

}  // namespace citykiln::charts
