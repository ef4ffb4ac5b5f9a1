#include "compiler/plants/appearance.h"

#include <algorithm>

namespace citykiln::plants {
namespace {

using Thousandths = std::array<int, 3>;

struct Row {
  Species species;
  Thousandths leaf, bark;
};

constexpr Row kRows[] = {
#define COLOURS(species, lr, lg, lb, br, bg, bb) {Species::species, {lr, lg, lb}, {br, bg, bb}},
#include "compiler/plants/species_colours.inc"
#undef COLOURS
};

materials::Tint tint_of(materials::Material material, const Thousandths& reflectance) {
  const auto& base = values_of(material).base_colour;
  materials::Tint tint = materials::kNoTint;
  for (std::size_t c = 0; c < 3; ++c)
    tint[c] =
        static_cast<std::uint8_t>(std::clamp(reflectance[c] * 0.255 / static_cast<double>(base[c]), 0.0, 255.0) + 0.5);
  return tint;
}

// Twigs are brown, however light the trunk is.
constexpr Thousandths kLightestTwig = {135, 105, 88};

Thousandths twig_of(const Thousandths& bark) {
  Thousandths twig;
  for (std::size_t c = 0; c < 3; ++c) twig[c] = std::min(bark[c], kLightestTwig[c]);
  return twig;
}

Thousandths mixed(const Thousandths& summer, const SeasonState& state) {
  Thousandths leaf;
  for (std::size_t c = 0; c < 3; ++c)
    leaf[c] = static_cast<int>(summer[c] + state.young * (state.young_leaf[c] - summer[c]) +
                               state.turned * (state.turned_leaf[c] - summer[c]));
  return leaf;
}

}  // namespace

Appearance appearance_of(Prototype prototype, Month month) {
  using materials::Material;
  const bool is_needle = values_of(prototype.species).leaves == LeafForm::kNeedle;
  const Material leaf = is_needle ? Material::kNeedleLeaf : Material::kBroadLeaf;
  const auto row = std::ranges::find(kRows, prototype.species, &Row::species);
  if (row == std::end(kRows)) return {leaf, materials::kNoTint, materials::kNoTint};
  const SeasonState state = season_state_of(prototype, month);
  // stalks are as their blades
  const bool is_blade = values_of(prototype.species).leaves == LeafForm::kBlade;
  const materials::Tint bark = tint_of(Material::kBark, is_blade ? mixed(row->bark, state) : row->bark);
  if (state.leaf_share == 0)
    return {Material::kBark, tint_of(Material::kBark, twig_of(row->bark)), bark, 0, state.height_share};
  return {leaf, tint_of(leaf, mixed(row->leaf, state)), bark, state.leaf_share, state.height_share};
}

}  // namespace citykiln::plants
