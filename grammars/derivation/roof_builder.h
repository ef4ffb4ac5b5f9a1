// The interface between roof operations and the code that builds roofs (DeriveOptions::roofs).
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "compiler/geometry/polygon.h"
#include "grammars/shapes/face.h"

namespace citykiln::grammars {

/// The roof operation of CGA: roofGable, roofHip, roofPyramid, roofShed or roofMansard.
enum class RoofKind : std::uint8_t { kGable, kHip, kPyramid, kShed, kMansard };

/// A requested roof, in the frame of the roofed face, in metres: the face is in the plane z = 0 and +z is its normal.
/// Over a horizontal face, x and y are those of the map plane.
struct RoofRequest {
  RoofKind kind = RoofKind::kHip;
  Polygon footprint;  ///< Outer ring counter-clockwise, holes clockwise.
  /// The angle of the roof planes with the footprint, unless by_height. kMansard: of the lower planes.
  double angle_deg = 0;
  double upper_angle_deg = 0;  ///< kMansard: the angle of the upper planes.
  bool by_height = false;      ///< The height is given instead of the angle.
  double height_m = 0;    ///< If by_height: the height of the highest point. kMansard: the height of the lower planes.
  double overhang_m = 0;  ///< The overhang of eaves and verges.
  std::size_t edge = 0;   ///< kShed: the index of the outer ring's edge at which the plane begins.
};

/// Returns the faces of the roof's solid, oriented outward, in the frame of the request. Tags: kTop (roof planes),
/// kSide (gables), kBorder (rims and undersides of overhangs) and kBottom (the base). Returns std::nullopt if the roof
/// cannot be built; the derivation then raises a warning and keeps the face.
///
/// Required: a pure function. The highest point is a vertex. In plan, no point is farther than kMostReach times the
/// overhang outside of the footprint. The base covers the footprint at z = 0.
using RoofBuilder = std::function<std::optional<std::vector<Face>>(const RoofRequest&)>;

/// The largest distance of an overhanging corner from the footprint, as a multiple of the overhang.
inline constexpr double kMostReach = 4;

}  // namespace citykiln::grammars
