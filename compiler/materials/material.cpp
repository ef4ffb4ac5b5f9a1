#include "compiler/materials/material.h"

#include <algorithm>
#include <cstddef>

namespace citykiln::materials {
namespace {

constexpr MaterialValues kTable[] = {
#define MATERIAL(name, r, g, b, roughness, metallic, variation) \
  {std::string_view(#name).substr(1), {r, g, b}, roughness, metallic, variation},
#include "compiler/materials/material_table.inc"
#undef MATERIAL
};

float computed_linear(int value) {
  // c^2.4 by c^2 · c^0.4, the fifth root by Newton: only + − × ÷, so that every CPU agrees
  const double c = value / 255.0;
  if (c <= 0.04045) return static_cast<float>(c / 12.92);
  const double base = (c + 0.055) / 1.055;
  double fifth = 1;  // base^(1/5)
  for (int i = 0; i < 30; ++i)
    fifth -= (fifth * fifth * fifth * fifth * fifth - base) / (5 * fifth * fifth * fifth * fifth);
  return static_cast<float>(base * base * fifth * fifth);
}

using LinearTable = std::array<float, 256>;

const LinearTable& linear_table() {
  static const LinearTable table = [] {
    LinearTable values{};
    for (int i = 0; i < 256; ++i) values[static_cast<std::size_t>(i)] = computed_linear(i);
    return values;
  }();
  return table;
}

}  // namespace

const MaterialValues& values_of(Material material) { return kTable[static_cast<std::size_t>(material)]; }

float linear_of_srgb(std::uint8_t value) { return linear_table()[value]; }

std::uint8_t srgb_of_linear(double reflectance) {
  const LinearTable& table = linear_table();
  const auto above = std::lower_bound(table.begin(), table.end(), reflectance);
  if (above == table.begin()) return 0;
  if (above == table.end()) return 255;
  const bool is_nearer_below = reflectance - *(above - 1) < *above - reflectance;
  return static_cast<std::uint8_t>(above - table.begin() - (is_nearer_below ? 1 : 0));
}

}  // namespace citykiln::materials
