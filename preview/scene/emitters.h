// Triangles that shine.
#pragma once

#include <cstdint>
#include <limits>

#include "compiler/geometry/vec.h"
#include "preview/rgb.h"

namespace citykiln::preview {

/// A triangle that shines from its front, in the world's frame.
struct Emitter {
  Vec3 corner, edge1, edge2;
  Rgb radiance{};  ///< Mean over the triangle, in the sky's unit.
};

inline constexpr std::uint32_t kNoEmitter = std::numeric_limits<std::uint32_t>::max();

}  // namespace citykiln::preview
