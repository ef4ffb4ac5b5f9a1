// Roofs: a surface over a footprint that closes a body together with walls and a floor.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "compiler/geometry/mesh.h"
#include "grammars/roofs/roof_shape.h"

namespace citykiln::roofs {

enum class Part : std::uint8_t {
  kRoof,   ///< Roof planes.
  kGable,  ///< Vertical: walls over the border of the footprint or between two teeth, up to the underside of the roof.
  kEdge,   ///< The vertical rim of overhanging eaves.
  kSoffit  ///< The underside of overhanging eaves.
};

/// Heights are metres over the eaves plane, where walls end. All coordinates are multiples of 2^-10 m.
struct Roof {
  std::vector<Vec3> positions;      ///< All of them are used by triangles, eaves or floor.
  std::vector<Triangle> triangles;  ///< Counter-clockwise from outside.
  std::vector<Part> parts;          ///< By triangle.
  /// By triangle: triangles with the same number and part are in one plane, or nearly; rims (kEdge) go around corners.
  std::vector<std::uint32_t> faces;
  /// The feet of the walls: rings of positions at height 0, the body on their left. They follow the footprint, with
  /// further points where a ridge or a valley ends in a gable.
  std::vector<std::vector<std::uint32_t>> eaves;
  std::vector<Triangle> floor;  ///< The plan within the eaves at height 0, facing up. Closes the roof.
  Form form = Form::kFlat;      ///< As built.
  double height_m = 0;          ///< Of the highest point.
  double error_m = 0;           ///< Bounds the distance to the roof at tolerance 0.
};

/// Roof, walls down to bottom_m and floor: a closed 2-manifold, oriented outward, without duplicate vertices.
/// @param bottom_m  < 0, and below the soffits if the body must not touch itself.
Mesh closed_body(const Roof& roof, double bottom_m);

}  // namespace citykiln::roofs
