// Finds the border of a set of triangles that share vertices.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "compiler/geometry/mesh.h"

namespace citykiln::grammars {

/// Returns the ring of vertices along the edges that belong to one triangle only, with the triangles on the left.
/// Returns std::nullopt if these edges are not one simple ring, or an edge occurs twice in the same direction. O(n log
/// n).
std::optional<std::vector<std::uint32_t>> border_ring(std::span<const Triangle> triangles);

}  // namespace citykiln::grammars
