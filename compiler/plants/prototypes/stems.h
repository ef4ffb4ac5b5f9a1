// Stems at a tolerance: the thick ones as smooth tubes, thin ones as prisms of three sides, the thinnest not at all.
#pragma once

#include "compiler/geometry/mesh.h"
#include "lsystems/skeleton.h"

namespace citykiln::plants {

struct StemMesh {
  Mesh mesh;
  std::vector<Vec2> uvs;  ///< One a position, as of lsystems::PlantMesh::bark; none without a picture.
  double error_m = 0;     ///< Hausdorff, both ways, to round stems, but for those left out.
};

/// Stems of a radius below the tolerance go, with all that they bear, if that is no thicker; but a trunk stays, since a
/// plant without one would hang in the air. Up to 2.5 tolerances they are prisms as wide as they are, which are no
/// farther from round than the tolerance. The rest: lsystems/tubes.h. O(segments).
///
/// @param bark_m  The side of the bark's picture; 0: none.
StemMesh mesh_stems(const lsystems::Skeleton& skeleton, double tolerance_m, double bark_m = 0);

}  // namespace citykiln::plants
