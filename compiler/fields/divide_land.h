// Divides one area of land into fields.
//
//    ┌────────────╱───────┐    1. lines of the map that run through it, such as tracks and streams, divide it into
//    faces │   ┆       ╱        │    2. faces wider than kWholeFace_m are cut into quarters: cells of a plane-wide
//    pattern │---┼------╱---------│    3. each piece is split square to a side of its smallest rectangle, until pieces
//    are as │   ┆     ╱    ┆     │       large as fields └────────╱───────────┘
//
// Source of the splits: Vanegas et al. 2012 (parcels/empty_lots.h), which splits pieces across their longer side only;
// here the side is the one whose halves have a form nearer to the usual one.
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

/// Faces with wider boxes, in metres, are cut into quarters, whose sites are kQuarter_m apart on average.
inline constexpr double kWholeFace_m = 1536, kQuarter_m = 896;
/// Fields depend on land and lines within this distance: that of the whole of a face, and of a quarter.
inline constexpr double kFieldRadius_m = 4 * kQuarter_m;

/// A field.
struct Field {
  Polygon polygon;           ///< Valid, snapped to the plane's grid.
  Vec2 along;                ///< The direction of its longer sides, a unit vector.
  std::uint32_t number = 0;  ///< A hash of its place; unique in the division.
};

/// A border between two pieces, a straight line, with a hash of its place.
struct FieldLine {
  Vec2 from, to;
  std::uint32_t number = 0;
};

/// An area divided into fields.
struct Division {
  std::vector<Field> fields;       ///< Sorted by number. They share no area, and cover the land but for slivers.
  std::vector<FieldLine> borders;  ///< Lines of splits; sorted by number.
};

/// Returns the usual fields at a place of the plane.
using RuleAt = std::function<FieldRule(Vec2)>;

/// Divides land into fields.
///
/// @param land   A valid polygon, snapped.
/// @param lines  Axes of lines that divide it. Each separates fields by kLineGap_m.
/// @param id     Selects the random draws.
/// Guarantees: bit-identical on all machines. A field depends on what lies within kFieldRadius_m of it, so the parts of
/// land that is cut off farther away do not matter. Pieces below a twelfth of the usual area are in no field.
/// Cost: O(n log n) for n points of land and lines, and O(m²) for each piece with m points.
Division divide(const Polygon& land, std::span<const Polyline> lines, const RuleAt& rule_at, StableId id,
                std::uint64_t seed);

/// The gap between fields on both sides of a line: narrower than what the line stands for.
inline constexpr double kLineGap_m = 0.5;

}  // namespace citykiln::fields
