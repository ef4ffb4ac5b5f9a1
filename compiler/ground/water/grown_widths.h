// The widths of waterways, which grow downstream where nothing is tagged.
//
//   spring ~~~~~~--------======  mouth          The width follows the length of all waterways upstream.
//                  /
//          ~~~~~~~'
#pragma once

#include <span>
#include <vector>

#include "compiler/geometry/box.h"
#include "compiler/map/features.h"

namespace citykiln::ground {

/// The width of a watercourse with one kilometre of watercourses upstream of it. The width grows with the square root
/// of that length: the width of rivers grows with the root of what they carry (Leopold and Maddock, "The hydraulic
/// geometry of stream channels", 1953), and that with the length of the channels that it comes from.
inline constexpr double kWidthAtOneKilometre_m = 1.5;

/// Returns the width of each waterway, in metres: its width_m if it is tagged, else one between least_width_m and
/// most_width_m by the length of all waterways that run into it, and half of its own, rounded to 1/8 m.
///
/// A waterway runs into another if its last point is a point of that one; where several go on, each gets an equal part.
/// One that enters the extent over its border begins with the length that its width_m stands for.
/// @param waterways  Sorted by id, directed downstream.
/// O(n log n) in points.
std::vector<double> grown_widths_m(std::span<const map::Waterway> waterways, const Box2& extent);

}  // namespace citykiln::ground
