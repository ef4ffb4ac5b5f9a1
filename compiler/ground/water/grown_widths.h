// The widths of waterways, which grow downstream where no width is tagged.
//
//   spring ~~~~~~--------======  mouth          The width follows the length of all waterways
//                  /                            upstream.
//          ~~~~~~~'
#pragma once

#include <span>
#include <vector>

#include "compiler/geometry/box.h"
#include "compiler/map/features.h"

namespace citykiln::ground {

/// The width in metres of a watercourse with one kilometre of watercourses upstream. Widths grow
/// with the square root of this length: the width of rivers grows with the root of their discharge
/// (Leopold and Maddock, "The hydraulic geometry of stream channels", 1953), and the discharge with
/// the length of the channels upstream.
inline constexpr double kWidthAtOneKilometre_m = 1.5;

/// Returns the width of each waterway, in metres and in their order. It is width_m if that is
/// tagged (most_width_m = 0). A width without a tag is computed from the length of all waterways
/// upstream and half of its own length, rounded to 1/8 m, and kept between least_width_m and
/// most_width_m.
///
/// A waterway runs into another if its last point is a point of the other, but not its last one.
/// Each of several such waterways gets an equal part of the length. A waterway that begins outside
/// of the extent, or within 1 m of its border, starts with the length that its width_m stands for.
/// A circle is cut before its waterway of the lowest id. O(n log n), n: points.
/// @param waterways  Sorted by id, directed downstream.
std::vector<double> grown_widths_m(std::span<const map::Waterway> waterways, const Box2& extent);

}  // namespace citykiln::ground
