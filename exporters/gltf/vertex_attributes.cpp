#include "exporters/gltf/vertex_attributes.h"

#include <cmath>
#include <cstring>

#include "exporters/gltf/compression.h"

namespace citykiln::exporters {
namespace {

struct Grid {
  const char* name;
  int exponent;
};
constexpr Grid kGrids[] = {{"POSITION", -10}, {"TEXCOORD_0", -9}, {"_FEATURE_ID_0", 0}};
static_assert(kPackedPosition_m == 0x1p-10 && kPackedUv_m == 0x1p-9);

constexpr double kMostSteps = 0x1p23 - 1;

}  // namespace

std::optional<Steps> steps_of(const VertexAttribute& attribute) {
  if (attribute.component != Component::kFloat) return std::nullopt;
  for (const Grid& grid : kGrids) {
    if (attribute.name != grid.name) continue;
    Steps steps{grid.exponent, std::vector<std::int32_t>(attribute.bytes.size() / sizeof(float))};
    for (std::size_t i = 0; i < steps.counts.size(); ++i) {
      float v = 0;
      std::memcpy(&v, attribute.bytes.data() + i * sizeof(float), sizeof(float));
      const double count = std::ldexp(double{v}, -grid.exponent);
      if (!(std::abs(count) <= kMostSteps) || count != std::floor(count)) return std::nullopt;
      steps.counts[i] = static_cast<std::int32_t>(count);
    }
    return steps;
  }
  return std::nullopt;
}

}  // namespace citykiln::exporters
