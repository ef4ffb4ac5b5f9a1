#include "compiler/map/row_direction.h"

#include <cmath>

#include "compiler/geometry/mathematics.h"
#include "compiler/geometry/trig.h"

namespace citykiln::map {

std::uint8_t row_heading_along(Vec2 direction) {
  const double half_turns = arctangent2_deg(direction.y, direction.x) / 180;
  return static_cast<std::uint8_t>(static_cast<int>(std::floor(half_turns * 256 + 0.5)) & 255);
}

Vec2 row_direction(std::uint8_t heading) { return direction_of(heading / 512.0); }

}  // namespace citykiln::map
