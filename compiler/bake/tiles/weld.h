// Welds primitives to one mesh whose vertices are shared by position. A primitive holds the triangles of one material.
// The welded mesh can be decimated, which means to remove vertices within a tolerance.
#pragma once

#include <map>
#include <span>
#include <vector>

#include "compiler/bake/baked_tile.h"
#include "compiler/simplify/decimate.h"

namespace citykiln::bake {

/// Numbers positions in the order of their first use, from 0. Equal positions get one number.
struct PositionNumbers {
  std::map<Float3, std::uint32_t> numbers;  ///< The number of each position.
  std::vector<Float3> positions;            ///< The position of each number.

  /// Returns the number of a position.
  std::uint32_t of(const Float3& p) {
    const auto [found, is_new] = numbers.emplace(p, static_cast<std::uint32_t>(positions.size()));
    if (is_new) positions.push_back(p);
    return found->second;
  }
};

/// The result of welded(). The label of a triangle is the index of its primitive in the span given to welded(),
/// where primitives that are not selected count too. A vertex is locked, so that decimation keeps it, if a primitive
/// has several uvs there, which is a seam of its texture.
struct WeldedPrimitives {
  simplify::LabelledMesh mesh;
  /// One map per primitive, from a vertex of `mesh` to the primitive's own first vertex at that position.
  std::vector<std::map<std::uint32_t, std::uint32_t>> vertex_at;
};

/// Welds the primitives that `is_in` selects. Triangles that are degenerate after welding are left out. O(n log n).
WeldedPrimitives welded(std::span<const Primitive> primitives, bool (*is_in)(const Primitive&));

/// Returns the primitive with only these triangles and their vertices, in the order of their first use.
Primitive with_triangles(const Primitive& from, std::span<const std::array<std::uint32_t, 3>> triangles);

/// Returns the triangles of a decimated mesh that belong to one primitive, with that primitive's own vertices.
/// @param from    The primitive before welding.
/// @param source  Result of welded().
/// @param label   Index of the primitive.
Primitive decimated_primitive(const Primitive& from, const WeldedPrimitives& source, std::uint32_t label,
                              const simplify::DecimatedMesh& decimated);

}  // namespace citykiln::bake
