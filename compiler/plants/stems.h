// Stems at a tolerance: the thick ones as smooth tubes, thin ones as prisms of three sides, the thinnest not at all.
#pragma once

#include "compiler/geometry/mesh.h"
#include "lsystems/skeleton.h"

namespace citykiln::plants {

struct StemMesh {
  Mesh mesh;
  double error_m = 0;  ///< Hausdorff, both ways, to round stems, but for those left out.
};

/// Stems of a radius below the tolerance go, with all that they bear, if that is no thicker; but a trunk stays, since a
/// plant without one would hang in the air. Up to 2.5 tolerances they are prisms as wide as they are, which are no
/// farther from round than the tolerance. The rest: lsystems/tubes.h. O(segments).
StemMesh mesh_stems(const lsystems::Skeleton& skeleton, double tolerance_m);

}  // namespace citykiln::plants
