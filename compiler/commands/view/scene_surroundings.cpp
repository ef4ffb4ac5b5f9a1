#include "compiler/commands/view/scene_surroundings.h"

#include <algorithm>
#include <cassert>

#include "compiler/map/plane/heightfield.h"
#include "compiler/scene/ground_lookup.h"

namespace citykiln::commands {
namespace {

using preview::operator+, preview::operator*;

constexpr int kPlaces = 256, kDirections = 64;
// Values are means over this many directions on both sides.
constexpr int kBlur = kDirections / 8;

preview::Rgb albedo_of(map::LandCoverClass cover) {
  const auto& colour = values_of(map::values_of(cover).material).base_colour;
  return {colour[0], colour[1], colour[2]};
}

// Returns the means of the places around a direction.
preview::Edge edge_of(const std::vector<scene::GroundPlace>& samples, int direction) {
  using preview::operator+, preview::operator*;
  preview::Edge edge;
  constexpr int kEach = kPlaces / kDirections, kReach = kBlur * kEach;
  double land = 0;
  for (int i = -kReach; i <= kReach; ++i) {
    const scene::GroundPlace& sample = samples[static_cast<std::size_t>(direction * kEach + i + kPlaces) % kPlaces];
    const bool is_sea = sample.cover == map::LandCoverClass::kSea;
    edge.height_m += (is_sea ? 0 : sample.height_m) / (2 * kReach + 1);
    if (is_sea)
      edge.sea += 1.0 / (2 * kReach + 1);
    else
      edge.albedo = edge.albedo + albedo_of(sample.cover), ++land;
  }
  if (land > 0) edge.albedo = edge.albedo * (1 / land);
  return edge;
}

// Replaces heights and sea of the samples by those at the end of the grid.
void stand_on(const surroundings::Surroundings& grid, std::vector<scene::GroundPlace>& samples) {
  const std::vector<Vec2> places = scene::places_on_border(grid.box(), kPlaces);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples[i].height_m = surroundings::height_m_at(grid, places[i]);
    const bool is_sea = surroundings::cover_at(grid, places[i]) == surroundings::Cover::kSea;
    if (is_sea)
      samples[i].cover = map::LandCoverClass::kSea;
    else if (samples[i].cover == map::LandCoverClass::kSea)
      samples[i].cover = map::LandCoverClass::kUnknown;
  }
}

std::vector<scene::GroundPlace> samples_on_border(const scene::GroundLookup& lookup) {
  std::vector<scene::GroundPlace> samples;
  for (const Vec2 place : scene::places_on_border(lookup.box(), kPlaces)) samples.push_back(lookup.at(place));
  return samples;
}

preview::Surroundings beyond(const Box2& box, const std::vector<scene::GroundPlace>& samples) {
  preview::Surroundings around{.box = box, .ring = {}};
  for (int i = 0; i < kDirections; ++i) around.ring.push_back(edge_of(samples, i));
  around.mean = preview::mean_of(around.ring);
  return around;
}

}  // namespace

preview::Surroundings plain_around(const scene::Scene& scene) {
  assert(!scene.chunks.empty());
  const scene::GroundLookup lookup(scene);
  return beyond(lookup.box(), samples_on_border(lookup));
}

preview::Surroundings surroundings_of(const scene::Scene& scene) {
  const surroundings::Surroundings& grid = scene.header.around;
  if (grid.is_empty()) return plain_around(scene);
  assert(!scene.chunks.empty());
  std::vector<scene::GroundPlace> samples = samples_on_border(scene::GroundLookup(scene));
  stand_on(grid, samples);
  return beyond(grid.box(), samples);
}

preview::Fog fog_of(const scene::Scene& scene, double share) {
  assert(!scene.chunks.empty() && share >= 0 && share <= 1);
  std::vector<double> heights_m;
  for (const scene::Chunk& chunk : scene.chunks) {
    const Box2 box = scene::box_of(scene.header, chunk.tile);
    for (int j = 0; j < chunk.heights.rows; ++j)
      for (int i = 0; i < chunk.heights.columns; ++i)
        if (box.contains(chunk.heights.vertex(i, j))) heights_m.push_back(chunk.heights.height_m_at_vertex(i, j));
  }
  if (heights_m.empty()) return {.top_m = scene.chunks.front().heights.height_m_at_vertex(0, 0)};
  const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(heights_m.size() - 1));
  std::ranges::nth_element(heights_m, heights_m.begin() + rank);
  return {.top_m = heights_m[static_cast<std::size_t>(rank)]};
}

}  // namespace citykiln::commands
