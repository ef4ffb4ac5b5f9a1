#include "exporters/gltf/plant_tints.h"

#include <algorithm>

namespace citykiln::exporters {

using materials::Tint;

Tint largest_tint(const bake::Primitive& p) {
  const bool is_on_atlas = p.colour_source == materials::ColourSource::kByMarkingAtlas ||
                           p.colour_source == materials::ColourSource::kByAtlas;
  const bool is_tinted = p.layer == bake::Layer::kPlants || p.material == materials::Material::kCarPaint;
  if (!is_tinted || is_on_atlas || p.colours.empty()) return materials::kNoTint;
  Tint largest = {0, 0, 0, 255};
  for (const Tint& tint : p.colours)
    for (std::size_t c = 0; c < 3; ++c) largest[c] = std::max(largest[c], tint[c]);
  return largest;
}

Tint share_of(Tint tint, Tint largest) {
  for (std::size_t c = 0; c < 3; ++c)
    if (largest[c] > 0) tint[c] = static_cast<std::uint8_t>((tint[c] * 255 + largest[c] / 2) / largest[c]);
  return tint;
}

Tint tint_of(Tint share, Tint largest) {
  for (std::size_t c = 0; c < 3; ++c) share[c] = static_cast<std::uint8_t>((share[c] * largest[c] + 127) / 255);
  return share;
}

}  // namespace citykiln::exporters
