// Materials of surfaces, with physically based values.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace citykiln::materials {

/// Rows of material_table.inc. The order is part of the manifest format: append only.
enum class Material : std::uint8_t {
#define MATERIAL(name, r, g, b, roughness, metallic, variation) name,
#include "compiler/materials/material_table.inc"
#undef MATERIAL
  kCount
};

struct MaterialValues {
  std::string_view name;             ///< Such as "Asphalt".
  std::array<float, 3> base_colour;  ///< Linear RGB reflectance.
  float roughness;
  float metallic;
  float variation;  ///< Largest relative change of brightness from object to object.
};

/// Returns the row of a material.
const MaterialValues& values_of(Material material);

/// The luminance of an emission of 1: about the luminance of the ceiling of a lit room.
inline constexpr double kEmission_cd_m2 = 100;

/// True for water, whose surface has waves.
inline bool is_water(Material material) {
  using enum Material;
  return material == kWater || material == kSea || material == kPoolWater || material == kRiverWater ||
         material == kShallowWater;
}

/// Returns the light that a material emits (emission_table.inc): linear RGB, 0…1 of kEmission_cd_m2; 0 for most
/// materials.
std::array<float, 3> emission_of(Material material);
inline bool emits(Material material) { return emission_of(material) != std::array<float, 3>{}; }

/// Returns the name of a material in plain words: "roof tile".
std::string words_of(Material material);

/// Returns the material that rule files name in snake case: kRoofTile for "roof_tile". O(rows).
std::optional<Material> material_named(std::string_view name);

/// Returns the lightest material with the look of a wall's or roof's material, so that light paints can tint it: of
/// most materials kPaint, which has no texture.
Material light_variant_of(Material material);

/// A colour that multiplies the base colour: linear, 255 = 1. Written as COLOR_0.
using Tint = std::array<std::uint8_t, 4>;
inline constexpr Tint kNoTint = {255, 255, 255, 255};

/// A material and its tint.
struct SurfaceMaterial {
  Material material{};
  Tint tint = kNoTint;
  auto operator<=>(const SurfaceMaterial&) const = default;
};

/// Converts sRGB 0…255 to linear reflectance 0…1 by a table: no libm, so the same bytes on every CPU.
float linear_of_srgb(std::uint8_t value);
/// Returns the sRGB value of the nearest linear reflectance, clamped to 0…1. Inverse of linear_of_srgb().
std::uint8_t srgb_of_linear(double reflectance);

}  // namespace citykiln::materials
