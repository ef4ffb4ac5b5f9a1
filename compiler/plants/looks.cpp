#include "compiler/plants/looks.h"

#include <algorithm>

namespace citykiln::plants {
namespace {

using Thousandths = std::array<int, 3>;

struct Row {
  Species species;
  Thousandths leaf, bark;
};

constexpr Row kRows[] = {
#define LOOK(species, lr, lg, lb, br, bg, bb) {Species::species, {lr, lg, lb}, {br, bg, bb}},
#include "compiler/plants/species_looks.inc"
#undef LOOK
};

materials::Tint tint_of(materials::Material material, const Thousandths& reflectance) {
  const auto& base = values_of(material).base_colour;
  materials::Tint tint = materials::kNoTint;
  for (std::size_t c = 0; c < 3; ++c)
    tint[c] =
        static_cast<std::uint8_t>(std::clamp(reflectance[c] * 0.255 / static_cast<double>(base[c]), 0.0, 255.0) + 0.5);
  return tint;
}

}  // namespace

Look look_of(Species species) {
  using materials::Material;
  const bool is_needle = values_of(species).leaves == Leaves::kNeedle;
  const Material leaf = is_needle ? Material::kNeedleLeaf : Material::kBroadLeaf;
  const auto row = std::ranges::find(kRows, species, &Row::species);
  if (row == std::end(kRows)) return {leaf, materials::kNoTint, materials::kNoTint};
  return {leaf, tint_of(leaf, row->leaf), tint_of(Material::kBark, row->bark)};
}

}  // namespace citykiln::plants
