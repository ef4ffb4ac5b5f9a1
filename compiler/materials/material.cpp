#include "compiler/materials/material.h"

#include <algorithm>
#include <cassert>
#include <cstddef>

namespace citykiln::materials {
namespace {

constexpr MaterialValues kMaterialValues[] = {
#define MATERIAL(name, r, g, b, roughness, metallic, variation) \
  {std::string_view(#name).substr(1), {r, g, b}, roughness, metallic, variation},
#include "compiler/materials/material_table.inc"
#undef MATERIAL
};

constexpr auto kEmissions = [] {
  std::array<std::array<float, 3>, static_cast<std::size_t>(Material::kCount)> emissions{};
#define EMISSION(name, r, g, b) emissions[static_cast<std::size_t>(Material::name)] = {r, g, b};
#include "compiler/materials/emission_table.inc"
#undef EMISSION
  return emissions;
}();

// c^2.4 as c² · (c^(1/5))², with the fifth root by Newton's method: only + − × ÷, for the same bytes on every CPU.
float computed_linear(int value) {
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

// Compares "RoofTile" with "roof_tile".
bool is_same_name(std::string_view camel, std::string_view snake) {
  std::size_t at = 0;
  for (const char c : camel) {
    const bool is_capital = c >= 'A' && c <= 'Z';
    if (is_capital && at > 0 && (at >= snake.size() || snake[at++] != '_')) return false;
    const char lower = is_capital ? static_cast<char>(c - 'A' + 'a') : c;
    if (at >= snake.size() || snake[at++] != lower) return false;
  }
  return at == snake.size();
}

}  // namespace

std::optional<Material> material_named(std::string_view name) {
  for (std::size_t i = 0; i < std::size(kMaterialValues); ++i)
    if (is_same_name(kMaterialValues[i].name, name)) return static_cast<Material>(i);
  return {};
}

std::string words_of(Material material) {
  std::string words;
  for (const char c : values_of(material).name) {
    const bool is_capital = c >= 'A' && c <= 'Z';
    if (is_capital && !words.empty()) words += ' ';
    words += is_capital ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return words;
}

Material light_variant_of(Material material) {
  switch (material) {
    case Material::kPlaster:
    case Material::kLightPlaster:
      return Material::kLightPlaster;
    case Material::kTimber:
    case Material::kShingles:
      return Material::kLightTimber;
    case Material::kBrick:
    case Material::kModularBrick:
    case Material::kEnglishBrick:
    case Material::kFlemishBrick:
    case Material::kStackBrick:
    case Material::kHeaderBrick:
      return Material::kLightBrick;
    case Material::kStone:
    case Material::kRubble:
      return Material::kLightStone;
    case Material::kConcrete:
    case Material::kShutteredConcrete:
      return Material::kLightConcrete;
    case Material::kMetalCladding:
    case Material::kCorrugatedSheet:
      return Material::kLightMetal;
    default:
      return Material::kPaint;
  }
}

const MaterialValues& values_of(Material material) {
  assert(material < Material::kCount);
  return kMaterialValues[static_cast<std::size_t>(material)];
}

std::array<float, 3> emission_of(Material material) {
  assert(material < Material::kCount);
  return kEmissions[static_cast<std::size_t>(material)];
}

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
