// Places of things that are mapped as lines or areas.
//
//     o   o   o   o   o        a line of bollards: copies, 1.5 m apart
//     [====][====][====]       a line of blocks: copies that touch, each about as wide as its row says
//     [================]       another line, such as a bench: one thing as long as the line, in its middle
//
//      _______________
//     |  [         ]  |        an area: one thing as large as the smallest rectangle around it
#pragma once

#include <optional>
#include <vector>

#include "compiler/geometry/polygon.h"
#include "compiler/map/things/thing_table.h"

namespace citykiln::map {

/// The place and size of a thing on a line or in an area. Plane metres.
struct OutlinePlace {
  Vec2 at;     ///< Its middle, snapped.
  Vec2 along;  ///< The direction of its width; length 1.
  double width_m = 0, depth_m = 0;
};

/// A rectangle with two sides along a direction.
struct OutlineRectangle {
  Vec2 middle, along;  ///< `along` has length 1.
  double length_m = 0, width_m = 0;
};
/// Returns the rectangle with the smallest area around a ring that has a side along one of its edges. O(n²).
OutlineRectangle smallest_rectangle(const Ring& ring);

/// A line or area gives a thing its size if no side gets longer than this times the side by tags or row. Otherwise the
/// thing keeps the size by tags or row.
inline constexpr double kMostStretch = 4;
/// The distance of copies that are narrower than half of it.
inline constexpr double kCopyDistance_m = 1.5;
/// The largest number of copies on a line.
inline constexpr std::size_t kMostCopies = 1000;

/// Returns the places of things on a line of two points or more. Things that may stand in a way (Stand::kInWay) get
/// copies, up to kMostCopies: narrow ones some kCopyDistance_m apart, wide ones so that they touch, in both cases at
/// equal steps. Others are one thing in the middle. O(n + copies · log n).
///
/// @param width_m, depth_m  The size by tags, else by the row, metres.
std::vector<OutlinePlace> places_on_line(const Polyline& line, Stand stand, double width_m, double depth_m);

/// Returns the place of a thing in an area: the middle of smallest_rectangle(). The longer side of the rectangle is
/// that of the longer one of width_m and depth_m. O(n²).
///
/// @param ring              The outer ring, three points or more.
/// @param width_m, depth_m  The size by tags, else by the row, metres.
OutlinePlace place_in_area(const Ring& ring, double width_m, double depth_m);

}  // namespace citykiln::map
