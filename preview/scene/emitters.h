// Emitters: triangles that shine.
#pragma once

#include <cstdint>
#include <limits>

#include "compiler/geometry/vec.h"
#include "preview/rgb.h"

namespace citykiln::preview {

/// A triangle that shines from its front, in the frame of the world: metres from the world's origin, z up.
struct Emitter {
  /// A corner, and the vectors from it to the two others. Counter-clockwise seen from the front.
  Vec3 corner, edge1, edge2;
  Rgb radiance{};  ///< Mean over the triangle, in the sky's unit.
};

/// The index of an emitter where there is none.
inline constexpr std::uint32_t kNoEmitter = std::numeric_limits<std::uint32_t>::max();

}  // namespace citykiln::preview
