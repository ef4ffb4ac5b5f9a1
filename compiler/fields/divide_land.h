// Divides one area of land into fields.
//
//    ┌────────────╱───────┐    1. Lines of the map that run through it, such as tracks and
//    │   ┆       ╱        │       streams, divide it into faces.
//    │---┼------╱---------│    2. Faces wider than kWholeFace_m are cut into quarters: cells of a
//    │   ┆     ╱    ┆     │       pattern of the whole plane.
//    └────────╱───────────┘    3. Pieces are split until they are as large as fields usually are.
//
// A piece is split at right angles to a side of its smallest rectangle: the side whose halves have
// a form nearer to FieldRule::aspect. Vanegas et al. 2012 (parcels/empty_lots.h), the source,
// always split the longer side. A face with FieldRule::is_grid in its middle is cut into squares of
// half a mile instead of quarters, whatever its size.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "compiler/contract/stable_id.h"
#include "compiler/fields/field_rules.h"
#include "compiler/geometry/polygon.h"

namespace citykiln::fields {

/// The width or height in metres of a face's box above which it is cut into quarters, and the mean
/// distance of the quarters' sites. A quarter is a cell of their Voronoi diagram.
inline constexpr double kWholeFace_m = 1536, kQuarter_m = 896;
/// The distance in metres within which land and lines can change a field: the size of a whole face,
/// and of the quarters about it.
inline constexpr double kFieldRadius_m = 4 * kQuarter_m;

/// One of the pieces into which land is divided.
struct Field {
  Polygon polygon;           ///< Valid, may have holes; multiples of kQuantum_m.
  Vec2 along;                ///< The direction of its longer side, a unit vector.
  std::uint32_t number = 0;  ///< A hash of its corner with the least x; unique in the division.
};

/// A straight border between two pieces of one face, with a hash of its middle, which is unique
/// among borders.
struct FieldBoundary {
  Vec2 from, to;
  std::uint32_t number = 0;
};

/// The fields of an area, and the borders between them.
struct Division {
  std::vector<Field> fields;           ///< Sorted by number. They share no area.
  std::vector<FieldBoundary> borders;  ///< Lines along which pieces were split; sorted by number.
};

/// Returns the usual fields at a point of the plane, in metres.
using RuleAt = std::function<FieldRule(Vec2)>;

/// Divides land into fields.
///
/// @param land     A valid polygon, snapped() to kQuantum_m.
/// @param lines    Axes of lines that divide it, with a gap of kLineGap_m between the fields.
/// @param rule_at  A pure function. Its area_m2 is multiplied by a draw from 0.7 to 1.4 for each
///                 face, or piece of a face in one quarter.
/// @param id       Selects the random draws, with `seed`.
///
/// A piece is a field once it is at most 1.4 times as large as usual. Pieces below a twelfth of the
/// usual area, gaps along lines and slivers are in no field. One of two fields whose numbers are
/// equal by chance, 1 in 2^28, is left out.
///
/// Guarantees: the result has the same bits on every CPU. A field depends on what lies within
/// kFieldRadius_m of it, so land may be cut off farther away.
/// Cost: O(n log n) for n points of land and lines, and O(m²) for each piece of m points.
Division divide(const Polygon& land, std::span<const Polyline> lines, const RuleAt& rule_at, StableId id,
                std::uint64_t seed);

/// The gap in metres between the fields on both sides of a line. It is narrower than the track or
/// stream that the line stands for.
inline constexpr double kLineGap_m = 0.5;

}  // namespace citykiln::fields
