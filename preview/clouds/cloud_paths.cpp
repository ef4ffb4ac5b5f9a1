#include "preview/clouds/cloud_paths.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "preview/surface/microfacet.h"
#include "preview/turn.h"

namespace citykiln::preview {

Vec3 scattered(Vec3 direction, double g, UnitPair chance) {
  const double s = (1 - g * g) / (1 - g + 2 * g * chance.u),
               cosine = std::clamp((1 + g * g - s * s) / (2 * g), -1.0, 1.0);
  const double sine = std::sqrt(1 - cosine * cosine);
  return unit(frame_about(direction).out_of(at_height(on_circle(chance.v) * sine, cosine)));
}

// The bits of the ray take the place of an object's id.
RayChance::RayChance(Vec3 from, Vec3 direction)
    : draw_(std::bit_cast<std::uint64_t>(from.x + 3 * from.y + 7 * from.z),
            StableId{std::bit_cast<std::uint64_t>(direction.x) ^
                     std::rotl(std::bit_cast<std::uint64_t>(direction.y), 21) ^
                     std::rotl(std::bit_cast<std::uint64_t>(direction.z), 42)},
            "cloud") {}

}  // namespace citykiln::preview
