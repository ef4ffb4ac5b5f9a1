#include "compiler/scene/yard_recipes.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "compiler/ground/plan.h"
#include "compiler/lots/draw_yard.h"
#include "compiler/plants/species_mix.h"

namespace citykiln::scene {
namespace {

// The recipes that a yard generates: its features, as later stages take them over.
struct YardObjects {
  std::vector<ground::LandCoverPolygon> surfaces;
  std::vector<props::Barrier> barriers;
  std::vector<plants::Tree> trees;
};

YardObjects objects_of(const lots::Yard& yard, std::uint64_t seed) {
  lots::DrawnYard features = lots::draw_yard(yard, seed);
  YardObjects objects{.surfaces = {}, .barriers = std::move(features.barriers), .trees = {}};
  for (const map::AreaFeature& area : features.areas) objects.surfaces.push_back(ground::surface_of(area));
  const plants::SpeciesMix usual = plants::species_mix_of(plants::PlantCommunity::kGardenTrees);
  for (const map::PointFeature& plant : features.plants)
    objects.trees.push_back({plant.id, plant.at, plant.height_m, plants::species_mix_for(plant.plant_tags, usual)});
  return objects;
}

// Marks the objects of a yard among `all`, and adds for each whether it is not there.
template <typename Object>
void find_generated(const std::vector<Object>& objects, const std::vector<Object>& all, std::vector<bool>& is_generated,
                    std::vector<bool>& suppressed) {
  for (const Object& object : objects) {
    const auto found = std::ranges::lower_bound(all, object.id, {}, &Object::id);
    const bool is_there = found != all.end() && *found == object;
    suppressed.push_back(!is_there);
    if (is_there) is_generated[static_cast<std::size_t>(found - all.begin())] = true;
  }
}

template <typename Object>
std::vector<Object> without(const std::vector<Object>& all, const std::vector<bool>& is_generated) {
  std::vector<Object> rest;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (!is_generated[i]) rest.push_back(all[i]);
  return rest;
}

// Adds those objects of a yard that are not suppressed; `number` counts them.
template <typename Object>
void add_generated(std::vector<Object>& objects, const std::vector<bool>& suppressed, std::size_t& number,
                   std::vector<Object>& all) {
  for (Object& object : objects)
    if (const std::size_t i = number++; i >= suppressed.size() || !suppressed[i]) all.push_back(std::move(object));
}

template <typename Object>
void merge_from(std::vector<Object>& all, std::size_t middle) {
  const auto at = all.begin() + static_cast<std::ptrdiff_t>(middle);
  std::ranges::sort(at, all.end(), {}, &Object::id);
  std::ranges::inplace_merge(all, at, {}, &Object::id);
}

}  // namespace

StrippedChunk strip_yards(const Chunk& chunk, std::uint64_t seed) {
  StrippedChunk stripped{.chunk = chunk};
  std::vector<bool> surfaces(chunk.surfaces.size()), barriers(chunk.barriers.size()), trees(chunk.trees.size());
  for (const lots::Yard& yard : chunk.yards) {
    const YardObjects objects = objects_of(yard, seed);
    std::vector<bool>& suppressed = stripped.suppressed.emplace_back();
    find_generated(objects.surfaces, chunk.surfaces, surfaces, suppressed);
    find_generated(objects.barriers, chunk.barriers, barriers, suppressed);
    find_generated(objects.trees, chunk.trees, trees, suppressed);
  }
  stripped.chunk.surfaces = without(chunk.surfaces, surfaces);
  stripped.chunk.barriers = without(chunk.barriers, barriers);
  stripped.chunk.trees = without(chunk.trees, trees);
  if (chunk.yards.empty() || restore_yards(StrippedChunk(stripped), seed) == chunk) return stripped;
  // lists that are not sorted, or ids that are not unique: nothing is stripped
  for (std::vector<bool>& suppressed : stripped.suppressed) suppressed.assign(suppressed.size(), true);
  return {chunk, std::move(stripped.suppressed)};
}

Chunk restore_yards(StrippedChunk&& stripped, std::uint64_t seed) {
  Chunk chunk = std::move(stripped.chunk);
  const std::size_t surfaces = chunk.surfaces.size(), barriers = chunk.barriers.size(), trees = chunk.trees.size();
  for (std::size_t i = 0; i < chunk.yards.size(); ++i) {
    static const std::vector<bool> kNone;
    const std::vector<bool>& suppressed = i < stripped.suppressed.size() ? stripped.suppressed[i] : kNone;
    YardObjects objects = objects_of(chunk.yards[i], seed);
    std::size_t number = 0;
    add_generated(objects.surfaces, suppressed, number, chunk.surfaces);
    add_generated(objects.barriers, suppressed, number, chunk.barriers);
    add_generated(objects.trees, suppressed, number, chunk.trees);
  }
  if (chunk.yards.empty()) return chunk;
  merge_from(chunk.surfaces, surfaces), merge_from(chunk.barriers, barriers), merge_from(chunk.trees, trees);
  return chunk;
}

}  // namespace citykiln::scene
