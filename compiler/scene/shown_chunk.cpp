#include "compiler/scene/shown_chunk.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include "compiler/scene/yard_recipes.h"

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

// Returns the ids of the surfaces that a chunk lacks, sorted.
std::vector<ObjectId> lost_surfaces(const Chunk& all, const Chunk& rest) {
  const auto ids_of = [](const Chunk& chunk) {
    std::vector<ObjectId> ids;
    for (const ground::LandCoverPolygon& surface : chunk.surfaces) ids.push_back(surface.id);
    std::ranges::sort(ids);
    return ids;
  };
  std::vector<ObjectId> lost;
  std::ranges::set_difference(ids_of(all), ids_of(rest), std::back_inserter(lost));
  return lost;
}

Chunk without_yards(const Chunk& chunk, std::uint64_t seed) {
  Chunk rest = strip_yards(chunk, seed).chunk;
  rest.yards.clear();
  const std::vector<ObjectId> lost = lost_surfaces(chunk, rest);
  const auto is_lost = [&](const ObjectId& id) { return std::ranges::binary_search(lost, id); };
  std::erase_if(rest.pitches, [&](const pitches::Pitch& bays) { return is_lost(bays.id); });
  std::erase_if(rest.woods, [&](const plants::Wood& wood) { return is_lost(wood.surface); });
  std::erase_if(rest.plantings, [&](const plants::Planting& planting) { return is_lost(planting.surface); });
  return rest;
}

}  // namespace

bool shows_recipes_as_they_are(const Shown& shown) {
  return shown.wood_density == 1 && !has(shown.left_out, SceneLayer::kYards);
}

Chunk shown_chunk(const Header& header, const Chunk& chunk) {
  const bool has_yards = !has(header.shown.left_out, SceneLayer::kYards);
  Chunk shown = has_yards ? chunk : without_yards(chunk, header.seed);
  if (header.shown.wood_density != 1) scale_woods(header.shown.wood_density, shown.woods);
  return shown;
}

std::shared_ptr<const Chunk> shared_shown_chunk(const Header& header, const Chunk& chunk) {
  if (shows_recipes_as_they_are(header.shown)) return {std::shared_ptr<const Chunk>(), &chunk};
  return std::make_shared<const Chunk>(shown_chunk(header, chunk));
}

}  // namespace citykiln::scene
