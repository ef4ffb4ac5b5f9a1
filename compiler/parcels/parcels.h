// Parcels: the land between streets, railways, water and other mapped land, divided into blocks and lots.
//
//    ══════════ street ══════════     a block is land that no line or mapped land cuts;
//      ┌────┬────┬──┬──┬──────┐       a lot is the part of a block that belongs to a
//      │ ▟▙ │ ▟▙ │▟▙│▟▙│  ▟▙  │       building, with a frontage on a street
//      ├────┴──┬─┴──┴──┴──┬───┤
//    ══════════ street ══════════
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/contract/stable_id.h"
#include "compiler/geometry/polygon.h"

namespace citykiln::parcels {

enum class LineKind : std::uint8_t {
  kStreet,   ///< Bounds blocks and gives lots access.
  kBarrier,  ///< Bounds blocks and gives no access: a railway, river or motorway.
  kNone      ///< Is ignored: a line on a bridge or in a tunnel.
};

/// Seen along a line's axis.
enum class Side : std::uint8_t { kLeft, kRight };

/// A line and its right-of-way: the land along it that no lot can have, such as a carriageway and its pavements.
struct Line {
  StableId id;                     ///< Unique among lines.
  Polyline axis;                   ///< Plane metres, snapped. Lines meet where their axes share a point.
  double left_m = 0, right_m = 0;  ///< From the axis to the right-of-way's edges; at least kLeastRightOfWay_m is used.
  LineKind kind = LineKind::kStreet;
  std::uint8_t left_size = 0, right_size = 0;  ///< The usual size of lots on each side: an index into Land::sizes.
};

struct Footprint {
  StableId id;  ///< Unique among footprints.
  Ring ring;    ///< Plane metres, snapped, counter-clockwise.
};

/// The usual size of lots of one kind. Lengths are limited to kDepth_m.
struct LotSize {
  double area_m2 = 600;    ///< Land without buildings is split until lots have at most 1.25 times this area.
  double frontage_m = 18;  ///< Land beside a building belongs to it up to this distance along the street.
  double depth_m = 40;     ///< Distance of the rear border from the street; more where the building is deeper.
};

/// The input of divide().
struct Land {
  Box2 extent;  ///< Its border closes blocks and gives no access.
  std::vector<Line> lines;
  std::vector<Polygon> taken;  ///< Land that no lot can have: water, parks, squares, forests, car parks.
  std::vector<Footprint> footprints;
  std::vector<LotSize> sizes = {LotSize{}};
  bool split_empty = false;  ///< True if land along streets without buildings is divided into lots too.
};

enum class BorderKind : std::uint8_t {
  kLine,    ///< The right-of-way of a line.
  kTaken,   ///< Taken land.
  kExtent,  ///< The border of the extent.
  kInner    ///< A lot or block on both sides.
};

/// The thing beyond an edge. Side, line and segment are set for kLine only.
struct Border {
  BorderKind kind = BorderKind::kInner;
  Side side = Side::kLeft;    ///< The side of the line.
  std::uint32_t line = 0;     ///< Index into Land::lines.
  std::uint32_t segment = 0;  ///< Index of the axis segment.
  bool operator==(const Border&) const = default;
};

/// A connected part of the land.
struct Block {
  Polygon polygon;
  std::vector<std::vector<Border>> borders;  ///< One for each edge of the outer ring, then of each hole.
  bool is_at_extent = false;                 ///< True if the extent cuts it.
};

/// A place on a line: the distance from the first point of an axis segment, along it. It may lie a little beyond the
/// segment's ends, at the edge of the right-of-way of a bend.
struct LinePlace {
  std::uint32_t segment = 0;
  double at_m = 0;
  bool operator==(const LinePlace&) const = default;
};

/// The part of a right-of-way's edge from which a lot is entered.
struct Frontage {
  std::uint32_t line = 0;
  Side side = Side::kLeft;
  LinePlace from, to;
  double length_m = 0;
  bool operator==(const Frontage&) const = default;
};

struct Lot {
  StableId id;  ///< Made of the line's id, its side, the ends of the axis segment, and the start of the frontage there.
  Polygon polygon;  ///< Its outer ring is simple. Holes are rare: taken land or a landlocked lot inside.
  std::uint32_t block = 0;
  Frontage frontage;
  std::vector<std::uint32_t> footprints;  ///< Indices of footprints, ascending; empty if nothing is built there.
  bool operator==(const Lot&) const = default;
};

/// Why a building has no lot.
enum class Cause : std::uint8_t {
  kOnLine,         ///< Most of it lies on streets and other lines.
  kOnTaken,        ///< Most of it lies on taken land.
  kOutside,        ///< Most of it lies outside the extent.
  kFarFromStreet,  ///< It lies farther than kDepth_m from the streets about it.
  kNoStreet,       ///< No street runs near it, or a barrier lies between.
  kWithoutArea,    ///< The ring has no area.
  kCount
};

struct Failure {
  Cause cause{};
  std::uint32_t footprint = 0;
  bool operator==(const Failure&) const = default;
};

struct Parcels {
  std::vector<Block> blocks;      ///< Sorted by their rings.
  std::vector<Lot> lots;          ///< Sorted by id.
  std::vector<Polygon> rest;      ///< Land of blocks that is in no lot, sorted by rings.
  std::vector<Failure> failures;  ///< Sorted by footprint.
};

/// The narrowest right-of-way beside an axis.
inline constexpr double kLeastRightOfWay_m = 0.25;
/// The largest distance of a lot's points from its street.
inline constexpr double kDepth_m = 64;

}  // namespace citykiln::parcels
