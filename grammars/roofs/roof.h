// A roof: a surface over the footprint of a building. Together with walls and a floor it encloses a solid. The eaves
// plane is the horizontal plane in which walls end.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "compiler/geometry/mesh.h"
#include "grammars/roofs/roof_shape.h"

namespace citykiln::roofs {

/// The part of a roof to which a triangle belongs.
enum class RoofPart : std::uint8_t {
  kRoof,  ///< Roof planes.
  /// Vertical walls above the eaves plane, up to the underside of the roof: over the border of the footprint, or
  /// between the teeth of a saw-tooth roof.
  kGable,
  kEdge,   ///< The vertical rim of overhanging eaves.
  kSoffit  ///< The underside of overhanging eaves.
};

/// A roof. x and y are in the frame of the footprint, z is the height over the eaves plane, in metres. All coordinates
/// are multiples of 2^-10 m.
struct Roof {
  std::vector<Vec3> positions;      ///< Each position is used by triangles, eaves or floor.
  std::vector<Triangle> triangles;  ///< Counter-clockwise from outside.
  std::vector<RoofPart> parts;      ///< By triangle.
  /// By triangle. Triangles with equal number and part are in one plane, or nearly; rims (kEdge) go around corners.
  std::vector<std::uint32_t> faces;
  /// The lines where roof and walls meet: rings of positions at height 0 with the body on their left. They follow the
  /// footprint, with further points where a ridge or a valley ends in a gable.
  std::vector<std::vector<std::uint32_t>> eaves;
  std::vector<Triangle> floor;      ///< The plan inside `eaves` at height 0, facing up.
  RoofForm form = RoofForm::kFlat;  ///< The form that was built.
  double height_m = 0;              ///< The height of the highest point.
  double error_m = 0;               ///< An upper bound of the distance to the roof generated at tolerance 0.
};

}  // namespace citykiln::roofs
