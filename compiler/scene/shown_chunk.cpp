#include "compiler/scene/shown_chunk.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>
#include <vector>

#include "compiler/contract/derived_id.h"
#include "compiler/lots/recipe.h"

namespace citykiln::scene {
namespace {

void scale_woods(double factor, std::vector<plants::Wood>& woods) {
  if (factor == 0) return woods.clear();
  for (plants::Wood& wood : woods) {
    const double trees = std::clamp(std::floor(wood.trees_per_ha * factor + 0.5), plants::kLeastTreesPerHa,
                                    std::max<double>(wood.trees_per_ha, plants::kMostTreesPerHa));
    wood.trees_per_ha = static_cast<std::uint16_t>(trees);
  }
}

// Finds the objects of some yards by their ids. Trimmed ones are not what the yards generate, but have their ids.
class YardIds {
 public:
  explicit YardIds(std::span<const lots::Yard> yards) {
    for (const lots::Yard& yard : yards) first_.push_back(derived_id(yard.building, lots::kPartsOfYard, 0));
    std::ranges::sort(first_);
  }

  bool has(ObjectId id) const {
    const auto after = std::ranges::upper_bound(first_, id);
    if (after == first_.begin()) return false;
    const ObjectId& first = *std::prev(after);
    return first.osm == id.osm && id.part - first.part < lots::kPartsOfYard;
  }

  template <typename Object>
  void erase_from(std::vector<Object>& objects) const {
    std::erase_if(objects, [&](const Object& object) { return has(object.id); });
  }

 private:
  std::vector<ObjectId> first_;
};

Chunk without_yards(const Chunk& chunk) {
  Chunk rest = chunk;
  const YardIds yards(chunk.yards);
  yards.erase_from(rest.surfaces);
  yards.erase_from(rest.barriers);
  yards.erase_from(rest.trees);
  rest.yards.clear();
  std::erase_if(rest.pitches, [&](const pitches::Pitch& bays) { return yards.has(bays.id); });
  std::erase_if(rest.woods, [&](const plants::Wood& wood) { return yards.has(wood.surface); });
  std::erase_if(rest.plantings, [&](const plants::Planting& planting) { return yards.has(planting.surface); });
  return rest;
}

}  // namespace

bool shows_recipes_as_they_are(const Shown& shown) {
  return shown.wood_density == 1 && !has(shown.left_out, SceneLayer::kYards);
}

Chunk shown_chunk(const Header& header, const Chunk& chunk) {
  const bool has_yards = !has(header.shown.left_out, SceneLayer::kYards);
  Chunk shown = has_yards ? chunk : without_yards(chunk);
  if (header.shown.wood_density != 1) scale_woods(header.shown.wood_density, shown.woods);
  return shown;
}

std::shared_ptr<const Chunk> shared_shown_chunk(const Header& header, const Chunk& chunk) {
  if (shows_recipes_as_they_are(header.shown)) return {std::shared_ptr<const Chunk>(), &chunk};
  return std::make_shared<const Chunk>(shown_chunk(header, chunk));
}

}  // namespace citykiln::scene
