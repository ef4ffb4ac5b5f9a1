#include "compiler/commands/scene_surroundings.h"

#include <algorithm>
#include <cassert>

#include "compiler/map/heightfield.h"

namespace citykiln::commands {
namespace {

using preview::operator+, preview::operator*;

constexpr int kPlaces = 256, kDirections = 64;
// Colours are means of as many directions on both sides.
constexpr int kBlur = kDirections / 8;

/// A place at the edge.
struct Sample {
  double height_m;
  map::LandCoverClass cover;
};

// A place on the border of a box, by its share of the way around from the middle of the eastern side.
Vec2 on_border(const Box2& box, int index) {
  const double turn = 8.0 * index / kPlaces;
  const auto along = [](double t) { return std::clamp(t < 4 ? 2 - std::abs(t - 2) : std::abs(t - 6) - 2, -1.0, 1.0); };
  const double y = along(turn), x = along(turn + 2 >= 8 ? turn - 6 : turn + 2);
  // within the box
  constexpr double kInside = 0.998;
  return box.centre() + Vec2{x * box.width() / 2, y * box.height() / 2} * kInside;
}

bool covers_place(const ground::LandCoverPolygon& polygon, Vec2 p) {
  int winding = 0;
  for (const Ring& ring : polygon.rings) winding += winding_number(ring, p);
  return winding > 0;
}

map::LandCoverClass cover_at(const scene::Chunk& chunk, Vec2 p) {
  const ground::LandCoverPolygon* top = nullptr;
  for (const ground::LandCoverPolygon& polygon : chunk.surfaces)
    if ((top == nullptr || ground::covers(polygon, *top)) && covers_place(polygon, p)) top = &polygon;
  return top != nullptr ? top->surface : map::LandCoverClass::kUnknown;
}

// The part of the region that has chunks.
Box2 chunks_box(const scene::Scene& scene) {
  Box2 box;
  for (const scene::Chunk& chunk : scene.chunks) {
    const Box2 of_chunk = scene::box_of(scene.header, chunk.tile);
    box.grow(of_chunk.min), box.grow(of_chunk.max);
  }
  return box;
}

const scene::Chunk& nearest_chunk(const scene::Scene& scene, Vec2 p) {
  return *std::ranges::min_element(scene.chunks, {}, [&](const scene::Chunk& chunk) {
    const Box2 box = scene::box_of(scene.header, chunk.tile);
    return distance(p, {std::clamp(p.x, box.min.x, box.max.x), std::clamp(p.y, box.min.y, box.max.y)});
  });
}

preview::Rgb albedo_of(map::LandCoverClass cover) {
  const auto& colour = values_of(map::values_of(cover).material).base_colour;
  return {colour[0], colour[1], colour[2]};
}

// Means of the places about a direction.
preview::Edge edge_of(const std::vector<Sample>& samples, int direction) {
  using preview::operator+, preview::operator*;
  preview::Edge edge;
  constexpr int kEach = kPlaces / kDirections, kReach = kBlur * kEach;
  double land = 0;
  for (int i = -kReach; i <= kReach; ++i) {
    const Sample& sample = samples[static_cast<std::size_t>(direction * kEach + i + kPlaces) % kPlaces];
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

}  // namespace

preview::Surroundings surroundings_of(const scene::Scene& scene) {
  assert(!scene.chunks.empty());
  const Box2 box = chunks_box(scene);
  std::vector<Sample> samples;
  for (int i = 0; i < kPlaces; ++i) {
    const Vec2 p = on_border(box, i);
    const scene::Chunk& chunk = nearest_chunk(scene, p);
    samples.push_back({map::height_m_at(chunk.heights, p), cover_at(chunk, p)});
  }
  preview::Surroundings around{.box = box, .ring = {}};
  for (int i = 0; i < kDirections; ++i) around.ring.push_back(edge_of(samples, i));
  around.mean = preview::mean_of(around.ring);
  return around;
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
