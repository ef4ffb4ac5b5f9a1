#include "compiler/plants/appearance.h"

#include <algorithm>

namespace citykiln::plants {
namespace {

materials::Tint tint_of_reflectance(materials::Material material, const Thousandths& reflectance) {
  const auto& base = values_of(material).base_colour;
  materials::Tint tint = materials::kNoTint;
  for (std::size_t c = 0; c < 3; ++c)
    tint[c] =
        static_cast<std::uint8_t>(std::clamp(reflectance[c] * 0.255 / static_cast<double>(base[c]), 0.0, 255.0) + 0.5);
  return tint;
}

// Twigs are brown even where the trunk is light.
constexpr Thousandths kLightestTwig = {135, 105, 88};

Thousandths twig_of(const Thousandths& bark) {
  Thousandths twig;
  for (std::size_t c = 0; c < 3; ++c) twig[c] = std::min(bark[c], kLightestTwig[c]);
  return twig;
}

// A summer colour mixed with the colours of young and turned leaves.
Thousandths mixed(const Thousandths& summer, const SpeciesValues& species, const SeasonState& state) {
  Thousandths leaf;
  for (std::size_t c = 0; c < 3; ++c)
    leaf[c] = static_cast<int>(summer[c] + state.young * (species.young_leaf[c] - summer[c]) +
                               state.turned * (species.turned_leaf[c] - summer[c]));
  return leaf;
}

}  // namespace

Appearance appearance_of(Prototype prototype, Month month) {
  return appearance_of(values_of(prototype.species), prototype.variant, month);
}

Appearance appearance_of(const SpeciesValues& species, std::uint8_t variant, Month month) {
  using materials::Material;
  const Material leaf = species.leaf_form == LeafForm::kNeedle ? Material::kNeedleLeaf : Material::kBroadLeaf;
  const SeasonState state = season_state_of(species, variant, month);
  // stalks of grasses have the colour of their blades
  const bool is_blade = species.leaf_form == LeafForm::kBlade;
  const materials::Tint bark =
      tint_of_reflectance(Material::kBark, is_blade ? mixed(species.bark, species, state) : species.bark);
  if (state.leaf_share == 0)
    return {.leaf_material = Material::kBark,
            .leaf = tint_of_reflectance(Material::kBark, twig_of(species.bark)),
            .bark = bark,
            .leaf_share = 0,
            .height_share = state.height_share};
  return {.leaf_material = leaf,
          .leaf = tint_of_reflectance(leaf, mixed(species.leaf, species, state)),
          .bark = bark,
          .leaf_share = state.leaf_share,
          .height_share = state.height_share};
}

}  // namespace citykiln::plants
