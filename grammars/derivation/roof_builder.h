// The door for roofs: what roofGable … ask for, and what they want back. The rooms that know roofs plug in here
// (DeriveOptions::roofs); without one, only what plain_roof() says is built.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "compiler/geometry/polygon.h"
#include "grammars/shapes/face.h"

namespace citykiln::grammars {

enum class RoofKind : std::uint8_t { kGable, kHip, kPyramid, kShed, kMansard };

/// In the frame of the roofed face: its plane is z = 0, +z the way its normal points; metres. Over a level face, x and
/// y are the plane's own.
struct RoofRequest {
  RoofKind kind = RoofKind::kHip;
  Polygon footprint;           ///< Outer counter-clockwise, holes clockwise.
  double angle_deg = 0;        ///< Of the roof planes, where not by height; of kMansard the lower, steep ones.
  double upper_angle_deg = 0;  ///< Of kMansard's upper planes.
  bool by_height = false;
  double height_m = 0;    ///< Of the highest point, where by height; of kMansard's lower part.
  double overhang_m = 0;  ///< Of eaves and verges.
  bool even = false;      ///< kGable: gables only where the skeleton is even; as CGA's `even`.
  std::size_t edge = 0;   ///< kShed: the outer ring's edge at which the plane begins.
};

/// Faces of the roof's solid, outward, tagged kTop (roof planes), kSide (gables), kBorder (rims and undersides of
/// overhangs), kBottom (the base); in the request's frame.
///
/// Has to guarantee: no point lies above the highest vertex, or in plan farther outside of the footprint than
/// kMostReach times the overhang; the base covers the footprint at z = 0. std::nullopt: this roof is not built; the
/// derivation then says so and goes on with the face as it was. A pure function of the request.
using RoofBuilder = std::function<std::optional<std::vector<Face>>(const RoofRequest&)>;

/// The longest mitre of an overhang, over the overhang.
inline constexpr double kMostReach = 4;

/// What needs no straight skeleton: pyramids and sheds on convex footprints without holes or overhang. A pyramid's apex
/// stands over the centroid, as high as the angle takes it above the nearest edge. O(n).
std::optional<std::vector<Face>> plain_roof(const RoofRequest& request);

}  // namespace citykiln::grammars
