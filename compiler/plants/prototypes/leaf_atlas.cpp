#include "compiler/plants/prototypes/leaf_atlas.h"

#include <algorithm>
#include <cassert>
#include <set>
#include <string>
#include <vector>

#include "compiler/plants/prototypes/sprays.h"

namespace citykiln::plants {
namespace {

// The rows of species.inc in their order: a species, then its sprays.
struct Row {
  bool is_species;
  std::string_view spray;
};

constexpr Row kRows[] = {
#define SPECIES(name, ...) {true, {}},
#define SPRAY(name, ...) {false, name},
#include "lsystems/species/species.inc"
};

LeafPicture without_leaves(std::string_view name, materials::Material material) { return {name, false, material, 1}; }

// All pictures of a month, each once.
std::set<LeafPicture> pictures_of(Month month) {
  std::set<LeafPicture> pictures;
  std::uint8_t species = 0;
  Appearance appearance;
  for (const Row& row : kRows) {
    if (row.is_species) {
      appearance = appearance_of({static_cast<Species>(species++), 0}, month);
      pictures.insert(without_leaves("", appearance.leaf_material));
      pictures.insert(without_leaves(kAnyFruit, appearance.leaf_material));
      continue;
    }
    for (const bool is_clump : {false, true})
      pictures.insert({row.spray, is_clump, appearance.leaf_material, appearance.leaf_share});
  }
  return pictures;
}

}  // namespace

LeafAtlas leaf_atlas(Month month) {
  LeafAtlas atlas;
  std::vector<impostor::Picture> pictures;
  const std::set<LeafPicture> shown = pictures_of(month);
  for (const LeafPicture& leaf : shown)
    pictures.push_back(picture_of_spray(leaf.spray, leaf.material, leaf.leaf_share, leaf.is_clump));
  std::vector<Vec2> sizes_m;
  for (const impostor::Picture& picture : pictures)
    sizes_m.push_back(Vec2{double(picture.columns), double(picture.rows)} * kSprayTexel);
  impostor::CutoutLayout layout = impostor::lay_out_cutout(std::move(pictures), kSprayTexel);
  assert(layout.cutout.colour.texel_m == kSprayTexel);
  std::size_t i = 0;
  for (const LeafPicture& leaf : shown) atlas.places[leaf] = {layout.at_m[i], sizes_m[i]}, ++i;
  atlas.cutout = std::move(layout.cutout);
  return atlas;
}

LeafPlace place_of(const LeafAtlas& atlas, std::string_view spray, bool is_clump, const Appearance& appearance) {
  const bool has_leaves = !spray.empty() && !is_fruit(spray);
  const LeafPicture own = has_leaves ? LeafPicture{spray, is_clump, appearance.leaf_material, appearance.leaf_share}
                                     : without_leaves(spray.empty() ? "" : kAnyFruit, appearance.leaf_material);
  const auto found = atlas.places.find(own);
  if (found != atlas.places.end()) return found->second;
  const auto alike = std::ranges::find_if(atlas.places, [&](const auto& place) {
    return place.first.spray == own.spray && place.first.is_clump == own.is_clump;
  });
  assert(alike != atlas.places.end());
  return alike->second;
}

}  // namespace citykiln::plants
