#include "compiler/materials/material.h"

#include <cstddef>

namespace citykiln::materials {
namespace {

constexpr MaterialValues kTable[] = {
#define MATERIAL(name, r, g, b, roughness, metallic, variation) \
  {std::string_view(#name).substr(1), {r, g, b}, roughness, metallic, variation},
#include "compiler/materials/material_table.inc"
#undef MATERIAL
};

}  // namespace

const MaterialValues& values_of(Material material) { return kTable[static_cast<std::size_t>(material)]; }

float linear_of_srgb(std::uint8_t value) {
  // c^2.4 by c^2 · c^0.4, the fifth root by Newton: only + − × ÷, so that every CPU agrees
  const double c = value / 255.0;
  if (c <= 0.04045) return static_cast<float>(c / 12.92);
  const double base = (c + 0.055) / 1.055;
  double fifth = 1;  // base^(1/5)
  for (int i = 0; i < 30; ++i)
    fifth -= (fifth * fifth * fifth * fifth * fifth - base) / (5 * fifth * fifth * fifth * fifth);
  return static_cast<float>(base * base * fifth * fifth);
}

}  // namespace citykiln::materials
