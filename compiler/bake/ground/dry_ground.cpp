#include "compiler/bake/ground/dry_ground.h"

#include <algorithm>
#include <cmath>

namespace citykiln::bake {
namespace {

using materials::Material;

// Linear reflectance of straw: dead grass as measured in the ASTER spectral library, rounded.
constexpr TintFactor kStraw = {0.300, 0.230, 0.115};

// Less than this changes a colour by less than its noise.
constexpr double kLeastDry = 0.02;

TintFactor base_colour_of(Material material) {
  const auto& colour = materials::values_of(material).base_colour;
  return {colour[0], colour[1], colour[2]};
}

TintFactor between(const TintFactor& a, const TintFactor& b, double share) {
  return {std::lerp(a.red, b.red, share), std::lerp(a.green, b.green, share), std::lerp(a.blue, b.blue, share)};
}

}  // namespace

Material dry_material_of(map::LandCoverClass cover, const ground::DryShares& dry) {
  if (dry.bare >= 0.5) return Material::kDryGround;
  return std::max(dry.straw, dry.bare) < kLeastDry ? values_of(cover).material : Material::kDryGrass;
}

TintFactor dry_tint(map::LandCoverClass cover, const ground::DryShares& dry) {
  const TintFactor soil = base_colour_of(Material::kDryGround);
  const TintFactor grass = between(base_colour_of(values_of(cover).material), kStraw, dry.straw);
  const TintFactor colour = between(grass, soil, dry.bare);
  return {std::min(colour.red / soil.red, 1.0), std::min(colour.green / soil.green, 1.0),
          std::min(colour.blue / soil.blue, 1.0)};
}

}  // namespace citykiln::bake
