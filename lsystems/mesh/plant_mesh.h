// The mesh of a plant: bark and leaves.
#pragma once

#include <cstddef>
#include <vector>

#include "compiler/geometry/mesh.h"

namespace citykiln::lsystems {

/// Positions, normals and uvs of vertices, and triangles that are counter-clockwise from outside. In the skeleton's
/// frame and unit.
struct PartMesh {
  std::vector<Vec3> positions;
  std::vector<Vec3> normals;  ///< Unit vectors.
  std::vector<Vec2> uvs;
  std::vector<Triangle> triangles;
};

/// Bark and leaves of a plant, with the error of the bark and counts.
struct PlantMesh {
  /// Closed if vertices of one position are merged. u runs around the stem (TubeOptions::bark_m), v along it in metres;
  /// both are continuous along a stem and through joints, except for jumps by whole texture periods, and at the
  /// beginnings of side stems.
  PartMesh bark;
  PartMesh leaf;  ///< Open surfaces; u across and v along the leaf, from 0 to 1.

  /// An upper bound of the Hausdorff distance between the bark and the surface that mesh_plant() approximates, not
  /// counting stems left out. At joints an estimate: 1.5 times the largest distance of measured joints.
  double error_m = 0;
  std::size_t joints = 0;          ///< The number of smooth joints of three or more stems.
  std::size_t separate_stems = 0;  ///< Stems closed on their own: roots, stems after f, side stems beyond the fourth.
  std::size_t left_out = 0;        ///< The number of segments, polygons and instances below the tolerance.
};

}  // namespace citykiln::lsystems
