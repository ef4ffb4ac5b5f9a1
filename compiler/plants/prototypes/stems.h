// Stems at a tolerance: thick ones as tubes, thin ones as triangular prisms, the thinnest left out.
#pragma once

#include "compiler/geometry/mesh.h"
#include "lsystems/skeleton.h"

namespace citykiln::plants {

struct StemMesh {
  Mesh mesh;
  std::vector<Vec2> uvs;  ///< One a position, as in lsystems::PlantMesh::bark; empty if bark_m is 0.
  double error_m = 0;     ///< Hausdorff distance to round stems, without those left out.
};

/// Meshes stems. A stem of a radius below the tolerance is left out if it carries nothing thicker; a radius above
/// 0.3 of the thickest diameter always stays, so that the plant stands on a trunk. Stems up to 2.5 tolerances are
/// prisms of the same mean width, within the tolerance of a round stem; one prism stands for all segments of an axis
/// that are within the tolerance of it. Others are tubes (lsystems/tubes.h).
/// O(segments).
///
/// @param tolerance_m  > 0, of radii.
/// @param bark_m  Side of the bark texture; 0: no texture coordinates.
StemMesh mesh_stems(const lsystems::Skeleton& skeleton, double tolerance_m, double bark_m = 0);

}  // namespace citykiln::plants
