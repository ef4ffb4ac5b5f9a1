#include "exporters/gltf/vertex_attributes.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace citykiln::exporters {
namespace {

constexpr int kFinestExponent = -10;
constexpr std::int64_t kMostSteps = (1 << 23) - 1;

bool has_steps(const std::string& name) {
  return name == "POSITION" || name == "TEXCOORD_0" || name == "_FEATURE_ID_0";
}

// A value as multiples of the finest step.
std::optional<std::int64_t> fine_steps(const unsigned char* at) {
  float v = 0;
  std::memcpy(&v, at, sizeof(float));
  const double count = std::ldexp(double{v}, -kFinestExponent);
  if (!(std::abs(count) <= 0x1p34) || count != std::floor(count)) return std::nullopt;
  return static_cast<std::int64_t>(count);
}

}  // namespace

std::optional<Steps> steps_of(const VertexAttribute& attribute) {
  if (attribute.component != Component::kFloat || !has_steps(attribute.name)) return std::nullopt;
  std::vector<std::int64_t> fine;
  std::uint64_t bits = std::uint64_t{1} << -kFinestExponent;
  for (std::size_t at = 0; at < attribute.bytes.size(); at += sizeof(float)) {
    const auto count = fine_steps(attribute.bytes.data() + at);
    if (!count) return std::nullopt;
    fine.push_back(*count), bits |= static_cast<std::uint64_t>(*count);
  }
  const int coarser = std::countr_zero(bits);
  Steps steps{kFinestExponent + coarser, {}};
  for (const std::int64_t count : fine) {
    if (std::abs(count >> coarser) > kMostSteps) return std::nullopt;
    steps.counts.push_back(static_cast<std::int32_t>(count >> coarser));
  }
  return steps;
}

}  // namespace citykiln::exporters
