#include "exporters/usd/usd_value.h"

#include <bit>
#include <cmath>
#include <iterator>

namespace citykiln::exporters {
namespace {

// In the order of the alternatives of UsdValue.
constexpr std::string_view kTypes[] = {"",        "bool",    "int",      "int64",    "float",   "double",   "string",
                                       "token",   "asset",   "float2",   "float3",   "float4",  "double3",  "int[]",
                                       "int64[]", "float[]", "float2[]", "float3[]", "quath[]", "string[]", "token[]"};
static_assert(std::size(kTypes) == std::variant_size_v<UsdValue>);

constexpr std::uint32_t kSmallestNormal = 0x38800000, kOverflow = 0x47800000, kInfinity = 0x7f800000;

// For magnitudes below 2^-14: adding 0.5 moves the bits to the end of the mantissa and rounds them.
std::uint32_t subnormal_half(std::uint32_t magnitude) {
  return std::bit_cast<std::uint32_t>(std::bit_cast<float>(magnitude) + 0.5f) - std::bit_cast<std::uint32_t>(0.5f);
}

}  // namespace

std::uint16_t half_bits(float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  const std::uint32_t sign = bits >> 16 & 0x8000, magnitude = bits & 0x7fffffff;
  if (magnitude >= kOverflow) return static_cast<std::uint16_t>(sign | (magnitude > kInfinity ? 0x7e00 : 0x7c00));
  if (magnitude < kSmallestNormal) return static_cast<std::uint16_t>(sign | subnormal_half(magnitude));
  const std::uint32_t odd = magnitude >> 13 & 1;
  return static_cast<std::uint16_t>(sign | ((magnitude - 0x38000000 + 0xfff + odd) >> 13));
}

float half_value(std::uint16_t bits) {
  const std::uint32_t sign = std::uint32_t{bits & 0x8000u} << 16, exponent = bits >> 10 & 31, fraction = bits & 0x3ff;
  if (exponent == 0) return (sign != 0 ? -1.0f : 1.0f) * static_cast<float>(fraction) * 0x1p-24f;
  const std::uint32_t wide = exponent == 31 ? 255 : exponent + 112;
  return std::bit_cast<float>(sign | wide << 23 | fraction << 13);
}

std::string_view usd_type_of(const UsdValue& value) { return kTypes[value.index()]; }

}  // namespace citykiln::exporters
