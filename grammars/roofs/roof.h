// A roof: a surface over a footprint that encloses a body together with walls and a floor.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "compiler/geometry/mesh.h"
#include "grammars/roofs/roof_shape.h"

namespace citykiln::roofs {

enum class Part : std::uint8_t {
  kRoof,  ///< Roof planes.
  /// Vertical walls above the eaves plane, up to the underside of the roof: over the border of the footprint, or
  /// between teeth.
  kGable,
  kEdge,   ///< The vertical rim of overhanging eaves.
  kSoffit  ///< The underside of overhanging eaves.
};

/// A roof. Heights are metres over the eaves plane, where walls end. All coordinates are multiples of 2^-10 m.
struct Roof {
  std::vector<Vec3> positions;      ///< Each is used by triangles, eaves or floor.
  std::vector<Triangle> triangles;  ///< Counter-clockwise from outside.
  std::vector<Part> parts;          ///< By triangle.
  /// By triangle. Triangles with one number and part are in one plane, or nearly; rims (kEdge) go around corners.
  std::vector<std::uint32_t> faces;
  /// The lines where roof and walls meet: rings of positions at height 0 with the body on their left. They follow the
  /// footprint, with further points where a ridge or a valley ends in a gable.
  std::vector<std::vector<std::uint32_t>> eaves;
  std::vector<Triangle> floor;  ///< The plan inside `eaves` at height 0, facing up.
  Form form = Form::kFlat;      ///< The form that was built.
  double height_m = 0;          ///< The height of the highest point.
  double error_m = 0;           ///< Bounds the distance to the roof at tolerance 0.
};

/// Returns roof, walls down to bottom_m and floor as one closed 2-manifold, oriented outward, without duplicate
/// vertices.
/// @param bottom_m  < 0, and below the soffits if the body must not touch itself.
Mesh closed_body(const Roof& roof, double bottom_m);

}  // namespace citykiln::roofs
