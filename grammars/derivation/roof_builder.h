// The interface between roof operations and the code that builds roofs (DeriveOptions::roofs).
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "compiler/geometry/polygon.h"
#include "grammars/shapes/face.h"

namespace citykiln::grammars {

enum class RoofKind : std::uint8_t { kGable, kHip, kPyramid, kShed, kMansard };

/// A roof to be built, in the frame of the roofed face: its plane is z = 0 and +z is along its normal; metres. Over a
/// horizontal face, x and y are those of the plane.
struct RoofRequest {
  RoofKind kind = RoofKind::kHip;
  Polygon footprint;           ///< Outer ring counter-clockwise, holes clockwise.
  double angle_deg = 0;        ///< Of the roof planes, unless by_height; of kMansard the lower planes.
  double upper_angle_deg = 0;  ///< Of the upper planes of kMansard.
  bool by_height = false;
  double height_m = 0;    ///< If by_height: of the highest point. Of the lower planes of kMansard.
  double overhang_m = 0;  ///< Of eaves and verges.
  bool even = false;      ///< CGA's `even` of roofGable.
  std::size_t edge = 0;   ///< Of kShed: the edge of the outer ring at which the plane begins.
};

/// Returns the faces of the roof's solid, oriented outward, in the frame of the request, tagged kTop (roof planes),
/// kSide (gables), kBorder (rims and undersides of overhangs) and kBottom (the base); std::nullopt if this roof cannot
/// be built, then the derivation raises a warning and keeps the face.
///
/// Required: a pure function. No point is above the highest vertex, or in plan farther outside of the footprint than
/// kMostReach times the overhang. The base covers the footprint at z = 0.
using RoofBuilder = std::function<std::optional<std::vector<Face>>(const RoofRequest&)>;

/// The longest mitre of an overhang, as a multiple of the overhang.
inline constexpr double kMostReach = 4;

}  // namespace citykiln::grammars
