// What lies at a place, told by borders alone.
#pragma once

#include <span>

#include "compiler/geometry/vec.h"
#include "compiler/ground/border.h"

namespace citykiln::ground {

/// What lies at a place, by the border straight above it. p must not lie on a border; the cell's own must be among
/// them, or it may be kNoSurface. Unlike a count of the surfaces' rings it stays true where borders have been moved.
/// O(borders).
std::uint32_t surface_between(std::span<const Border> borders, Vec2 p);

}  // namespace citykiln::ground
