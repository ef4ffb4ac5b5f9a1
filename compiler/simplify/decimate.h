// Decimation of surfaces whose triangles have labels, by edge collapses of OpenMesh, with a certified error.
//
//     v goes to u:   inside a label along any edge       on the border of two labels      elsewhere it stays: at the
//                    \ | /       \   /                   along the border only            mesh's corners, where three
//                   -- v -- u  →  -- u                    ══ v ══ u  →  ═════ u           labels meet, where it is
//                   locked
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "compiler/geometry/mesh.h"

namespace citykiln::simplify {

/// Triangles that share vertices. Each has a label, such as the material it shows.
struct LabelledMesh {
  std::vector<Vec3> positions;  ///< Equal positions count as different, unconnected vertices.
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> labels;  ///< One per triangle; below 2^31.
  std::vector<bool> is_locked;        ///< One per position: true if the vertex must stay. Empty: no vertex must stay.
};

/// The result of decimation.
struct DecimatedMesh {
  std::vector<Triangle> triangles;  ///< Indices into the positions of the source, none of which moves.
  std::vector<std::uint32_t> labels;
  /// Bound of the two-sided Hausdorff distance of a label's triangles before and after, the largest of all labels. Not
  /// below half of the tolerance, since smaller distances are not measured; 0 if the source is returned.
  double error_m = 0;
};

/// Returns the mesh with fewer triangles; error_m <= tolerance_m.
///
/// Guarantees: locked vertices and edges between two of them stay, so meshes that share locked borders still meet; the
/// outline of each label moves by at most the tolerance; a collapse turns a triangle by at most 60°, and triangles that
/// face up still do; same input, same bytes, on every CPU. Accepts any mesh: where it is no manifold, it is taken
/// apart, and the vertices there are locked.
/// Method: OpenMesh's quadric errors set the order (Garland, Heckbert, SIGGRAPH 1997), and its ModHausdorff, which
/// follows samples of the source, ends collapses that stray. Samples are no proof, so the result is measured
/// (distance_bound.h). Where the result is farther from the source than the tolerance, vertices of the source are
/// locked and the mesh is decimated again; if that does not end in some rounds, the source is returned.
/// Cost: 0.1 ms a triangle, and 2 µs a square of the tolerance.
DecimatedMesh decimated(const LabelledMesh& mesh, double tolerance_m);

/// Returns the mesh with about `triangles` triangles, or more if the method above cannot remove enough. It uses the
/// smallest of several tolerances (0.02 to 20 m, for samples and borders) that suffices. error_m is not measured and 0.
DecimatedMesh decimated_to(const LabelledMesh& mesh, std::size_t triangles);

}  // namespace citykiln::simplify
