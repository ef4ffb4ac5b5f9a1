// The way around triangles that share vertices.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "compiler/geometry/mesh.h"

namespace citykiln::grammars {

/// The vertices along all edges whose opposites are not there too, triangles to the left, from where the first such
/// edge starts. Nothing where that is not one ring which comes to each vertex once, or triangles lie on each other. O(n
/// log n).
std::optional<std::vector<std::uint32_t>> border_ring(std::span<const Triangle> triangles);

}  // namespace citykiln::grammars
