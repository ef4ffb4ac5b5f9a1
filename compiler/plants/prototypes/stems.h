// Meshes stems at a tolerance: thick ones as tubes, thin ones as triangular prisms; the thinnest are left out.
#pragma once

#include "compiler/geometry/mesh.h"
#include "lsystems/rewriting/skeleton.h"

namespace citykiln::plants {

/// Stems as a mesh, in the skeleton's units.
struct StemMesh {
  Mesh mesh;
  std::vector<Vec2> uvs;  ///< One per position, as in lsystems::PlantMesh::bark; empty if bark_m is 0.
  /// An upper bound of the Hausdorff distance to round stems, not counting those left out. At joints of tubes it is an
  /// estimate, 1.5 times the largest measured distance.
  double error_m = 0;
};

/// Meshes stems. A stem whose radius is below the tolerance is left out if it carries nothing thicker. A radius above
/// 0.3 of the thickest diameter always stays, so the plant stands on a trunk. Stems up to 2.5 tolerances are prisms of
/// equal mean width, within the tolerance of a round stem; one prism replaces all segments of an axis that are within
/// the tolerance of it. Thicker stems are tubes (lsystems/mesh/tubes.h).
/// O(segments).
///
/// @param tolerance_m  > 0, compared with radii.
/// @param bark_m  The side of the bark texture; 0: no texture coordinates.
StemMesh mesh_stems(const lsystems::Skeleton& skeleton, double tolerance_m, double bark_m = 0);

}  // namespace citykiln::plants
