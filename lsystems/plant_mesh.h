// A plant as triangles: bark and leaves apart, plain data.
#pragma once

#include <cstddef>
#include <vector>

#include "compiler/geometry/mesh.h"

namespace citykiln::lsystems {

/// One entry a vertex in the first three; triangles counter-clockwise from outside. TurtleFrame and unit are the
/// skeleton's.
struct PartMesh {
  std::vector<Vec3> positions;
  std::vector<Vec3> normals;  ///< Of length 1.
  std::vector<Vec2> uvs;
  std::vector<Triangle> triangles;
};

struct PlantMesh {
  /// u around the stem (TubeOptions::bark_m), v in metres along it: where a stem goes on both do, through joints too,
  /// but for whole pictures. A side stem's begin where it leaves. Closed where vertices in one place count as one.
  PartMesh bark;
  PartMesh leaf;  ///< u across, v along, 0 … 1. Open: a leaf has two sides and no thickness.

  /// From the bark to what it stands for (see mesh_plant), Hausdorff, both ways; without what was left out.
  double error_m = 0;
  std::size_t joints = 0;  ///< Smooth ones, of three stems and more.
  std::size_t separate_stems =
      0;                     ///< Stems that are closed alone: roots, those behind f, and more than four from one place.
  std::size_t left_out = 0;  ///< Segments, polygons and instances that are thinner or smaller than the tolerance.
};

}  // namespace citykiln::lsystems
