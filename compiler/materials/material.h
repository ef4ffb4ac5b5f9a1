// What surfaces are made of: physically based values, one row a material.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace citykiln::materials {

/// Rows of the table in material_table.inc. The order is part of the manifest's format: add at the end.
enum class Material : std::uint8_t {
#define MATERIAL(name, r, g, b, roughness, metallic, variation) name,
#include "compiler/materials/material_table.inc"
#undef MATERIAL
  kCount
};

struct MaterialValues {
  std::string_view name;             ///< "Asphalt".
  std::array<float, 3> base_colour;  ///< Linear RGB reflectance.
  float roughness;
  float metallic;
  float variation;  ///< Largest relative change of brightness from object to object.
};

const MaterialValues& values_of(Material material);

/// What an emission of 1 stands for: a lit room's ceiling.
inline constexpr double kEmission_cd_m2 = 100;

/// Light that a surface sends out by itself: linear RGB, 0…1 of kEmission_cd_m2; of most none.
std::array<float, 3> emission_of(Material material);
inline bool emits(Material material) { return emission_of(material) != std::array<float, 3>{}; }

/// By its name in rules and settings: "roof_tile" is kRoofTile. Nothing where no row has it. O(rows).
std::optional<Material> material_named(std::string_view name);

/// A colour that multiplies the base colour: linear, 255 = 1. Written as COLOR_0.
using Tint = std::array<std::uint8_t, 4>;
inline constexpr Tint kNoTint = {255, 255, 255, 255};

/// sRGB 0…255 to linear reflectance 0…1 by table (no libm, same bytes on every CPU).
float linear_of_srgb(std::uint8_t value);
/// The sRGB value whose linear reflectance is nearest; what is beyond 0…1 becomes 0 or 255. Inverse of linear_of_srgb.
std::uint8_t srgb_of_linear(double reflectance);

}  // namespace citykiln::materials
