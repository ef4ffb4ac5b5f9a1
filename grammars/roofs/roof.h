// A roof: a surface over a footprint, that together with walls and a floor closes a body.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "compiler/geometry/mesh.h"
#include "grammars/roofs/roof_shape.h"

namespace citykiln::roofs {

enum class Part : std::uint8_t {
  kRoof,   ///< What it rains on.
  kGable,  ///< Upright, over the footprint's border or between two teeth of a saw: wall, up to the roof's underside.
  kEdge,   ///< The upright rim of eaves that stand out.
  kSoffit  ///< Eaves that stand out, from below.
};

/// Heights are metres over the eaves plane, where walls end. All coordinates are multiples of 2^-10 m.
struct Roof {
  std::vector<Vec3> positions;      ///< Each used by the triangles, the eaves or the floor.
  std::vector<Triangle> triangles;  ///< Counter-clockwise from outside.
  std::vector<Part> parts;          ///< One a triangle.
  /// One a triangle: those with one number, and one part, lie in one plane, or nearly; rims (kEdge) go around corners.
  std::vector<std::uint32_t> faces;
  /// Where the walls stand: rings of positions at height 0, the body to their left. They run along the footprint, with
  /// further points where a ridge or a valley ends in a gable.
  std::vector<std::vector<std::uint32_t>> eaves;
  std::vector<Triangle> floor;  ///< The plan within the eaves, looking up, at height 0. Together with the rest: closed.
  Form form = Form::kFlat;      ///< What it became.
  double height_m = 0;          ///< Of its highest point.
  double error_m = 0;           ///< Largest distance from the roof at tolerance 0.
};

/// Roof, walls down to bottom_m and floor: a closed 2-manifold, looking outward, no vertex twice. bottom_m < 0, and
/// below the soffits for it not to touch itself.
Mesh closed_body(const Roof& roof, double bottom_m);

}  // namespace citykiln::roofs
