#include "compiler/verify/standing/measure_trunks.h"

#include <optional>
#include <string_view>

#include "compiler/verify/standing/taken_land.h"

namespace citykiln::verify {
namespace {

using plants::Species;

/// True for names of tree prototypes, "oak_3"; false for others, "PostTopLamp".
bool is_tree(std::string_view name, const plants::SpeciesTable& table) {
  const std::optional<Species> species = table.named(name.substr(0, name.rfind('_')));
  return species && *species != Species::kHedge && table[*species].leaf_form != plants::LeafForm::kBlade;
}

}  // namespace

Trunks measure_trunks(const bake::BakedTile& tile, const ground::LandCoverIndex& land_cover,
                      const plants::SpeciesTable& species) {
  Trunks trunks;
  for (const bake::InstancedMesh& instanced : tile.instanced) {
    if (!is_tree(instanced.name, species)) continue;
    for (std::size_t i = 0; i < instanced.translations.size(); ++i) {
      const bake::Float3& offset = instanced.translations[i];
      const Vec2 at = in_plan(Vec3{offset[0], offset[1], offset[2]} + tile.origin);
      ++trunks.tested;
      if (taken_land_at(land_cover, at) == nullptr) continue;
      if (trunks.conflicts++ == 0) trunks.at = at, trunks.element = tile.features[instanced.features[i]];
    }
  }
  return trunks;
}

}  // namespace citykiln::verify
