#include "compiler/scene/yard_recipes.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "compiler/ground/plan.h"
#include "compiler/lots/draw_yard.h"
#include "compiler/plants/species_mix.h"

namespace citykiln::scene {
namespace {

// The recipes that a yard draws: its features, as the later stages take them over.
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

// Moves the objects that are in `all` to `drawn`, and adds for each whether it was not there.
template <typename Object>
void find_drawn(const std::vector<Object>& objects, const std::vector<Object>& all, std::vector<bool>& is_drawn,
                std::vector<bool>& left_out) {
  for (const Object& object : objects) {
    const auto found = std::ranges::lower_bound(all, object.id, {}, &Object::id);
    const bool is_there = found != all.end() && *found == object;
    left_out.push_back(!is_there);
    if (is_there) is_drawn[static_cast<std::size_t>(found - all.begin())] = true;
  }
}

template <typename Object>
std::vector<Object> without(const std::vector<Object>& all, const std::vector<bool>& is_drawn) {
  std::vector<Object> rest;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (!is_drawn[i]) rest.push_back(all[i]);
  return rest;
}

// Adds those objects of a yard that are not left out; `number` counts them.
template <typename Object>
void add_drawn(std::vector<Object>& objects, const std::vector<bool>& left_out, std::size_t& number,
               std::vector<Object>& all) {
  for (Object& object : objects)
    if (const std::size_t i = number++; i >= left_out.size() || !left_out[i]) all.push_back(std::move(object));
}

template <typename Object>
void merge_from(std::vector<Object>& all, std::size_t middle) {
  const auto at = all.begin() + static_cast<std::ptrdiff_t>(middle);
  std::ranges::sort(at, all.end(), {}, &Object::id);
  std::ranges::inplace_merge(all, at, {}, &Object::id);
}

}  // namespace

LeanChunk lean(const Chunk& chunk, std::uint64_t seed) {
  LeanChunk lean{.chunk = chunk};
  std::vector<bool> surfaces(chunk.surfaces.size()), barriers(chunk.barriers.size()), trees(chunk.trees.size());
  for (const lots::Yard& yard : chunk.yards) {
    const YardObjects objects = objects_of(yard, seed);
    std::vector<bool>& left_out = lean.left_out.emplace_back();
    find_drawn(objects.surfaces, chunk.surfaces, surfaces, left_out);
    find_drawn(objects.barriers, chunk.barriers, barriers, left_out);
    find_drawn(objects.trees, chunk.trees, trees, left_out);
  }
  lean.chunk.surfaces = without(chunk.surfaces, surfaces);
  lean.chunk.barriers = without(chunk.barriers, barriers);
  lean.chunk.trees = without(chunk.trees, trees);
  if (chunk.yards.empty() || drawn(LeanChunk(lean), seed) == chunk) return lean;
  // lists that are not sorted, or ids that are not unique: nothing is drawn
  for (std::vector<bool>& left_out : lean.left_out) left_out.assign(left_out.size(), true);
  return {chunk, std::move(lean.left_out)};
}

Chunk drawn(LeanChunk&& lean, std::uint64_t seed) {
  Chunk chunk = std::move(lean.chunk);
  const std::size_t surfaces = chunk.surfaces.size(), barriers = chunk.barriers.size(), trees = chunk.trees.size();
  for (std::size_t i = 0; i < chunk.yards.size(); ++i) {
    static const std::vector<bool> kNone;
    const std::vector<bool>& left_out = i < lean.left_out.size() ? lean.left_out[i] : kNone;
    YardObjects objects = objects_of(chunk.yards[i], seed);
    std::size_t number = 0;
    add_drawn(objects.surfaces, left_out, number, chunk.surfaces);
    add_drawn(objects.barriers, left_out, number, chunk.barriers);
    add_drawn(objects.trees, left_out, number, chunk.trees);
  }
  if (chunk.yards.empty()) return chunk;
  merge_from(chunk.surfaces, surfaces), merge_from(chunk.barriers, barriers), merge_from(chunk.trees, trees);
  return chunk;
}

}  // namespace citykiln::scene
