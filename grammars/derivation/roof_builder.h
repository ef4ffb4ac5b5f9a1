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

/// A requested roof, in the frame of the roofed face, in metres: the face is in the plane z = 0 and +z is its normal.
/// Over a horizontal face, x and y are those of the map plane.
struct RoofRequest {
  RoofKind kind = RoofKind::kHip;
  Polygon footprint;           ///< Outer ring counter-clockwise, holes clockwise.
  double angle_deg = 0;        ///< The angle of the roof planes (kMansard: the lower ones), unless by_height.
  double upper_angle_deg = 0;  ///< kMansard: the angle of the upper planes.
  bool by_height = false;
  double height_m = 0;    ///< If by_height: the height of the highest point; kMansard: that of the lower planes.
  double overhang_m = 0;  ///< The overhang of eaves and verges.
  bool even = false;      ///< CGA's `even` of roofGable.
  std::size_t edge = 0;   ///< kShed: the edge of the outer ring at which the plane begins.
};

/// Returns the faces of the roof's solid, oriented outward, in the frame of the request. Tags: kTop (roof planes),
/// kSide (gables), kBorder (rims and undersides of overhangs) and kBottom (the base). Returns std::nullopt if the roof
/// cannot be built; the derivation then raises a warning and keeps the face.
///
/// Required: a pure function. No point is above the highest vertex, and none is, in plan, farther outside of the
/// footprint than kMostReach times the overhang. The base covers the footprint at z = 0.
using RoofBuilder = std::function<std::optional<std::vector<Face>>(const RoofRequest&)>;

/// The longest mitre of an overhang, as a multiple of the overhang.
inline constexpr double kMostReach = 4;

}  // namespace citykiln::grammars
