#include "compiler/commands/layers/scene_heights.h"

#include <algorithm>
#include <cmath>

#include "compiler/contract/for_each_slot.h"
#include "compiler/scene/graded_terrain.h"

namespace citykiln::commands {
namespace {

// A tolerance without kerbs: objects stand on the higher side.
constexpr double kTolerance_m = 0.5;

double distance_m(const Box2& box, Vec2 p) {
  return std::max({box.min.x - p.x, p.x - box.max.x, box.min.y - p.y, p.y - box.max.y, 0.0});
}

// Returns the chunk whose tile is nearest to a place, usually the tile that contains it.
std::size_t chunk_near(const scene::Scene& scene, Vec2 p) {
  const auto column = static_cast<std::int32_t>(std::floor(p.x / scene.header.tile_m)),
             row = static_cast<std::int32_t>(std::floor(p.y / scene.header.tile_m));
  const scene::TileKey tile{column, row};
  const auto found = std::ranges::lower_bound(scene.chunks, tile, {}, &scene::Chunk::tile);
  if (found != scene.chunks.end() && found->tile == tile) return static_cast<std::size_t>(found - scene.chunks.begin());
  const auto nearest = std::ranges::min_element(scene.chunks, {}, [&](const scene::Chunk& chunk) {
    return distance_m(scene::box_of(scene.header, chunk.tile), p);
  });
  return static_cast<std::size_t>(nearest - scene.chunks.begin());
}

template <typename HeightIn>
double height_m(const SceneHeights& heights, Vec2 p, HeightIn height_in) {
  const std::size_t i = chunk_near(heights.scene, p);
  const scene::Chunk& chunk = heights.scene.chunks[i];
  if (scene::box_of(heights.scene.header, chunk.tile).contains(p)) return height_in(heights.graded[i]);
  return map::height_m_at(chunk.heights, p);
}

}  // namespace

SceneHeights heights_of(const scene::Scene& scene) {
  SceneHeights heights{scene, {}};
  for (const scene::Chunk& chunk : scene.chunks)
    heights.graded.push_back(scene::graded_terrain_of(scene.header, chunk, kTolerance_m));
  return heights;
}

double land_m(const SceneHeights& heights, Vec2 p) {
  return height_m(heights, p, [&](const ground::GradedTerrain& graded) { return ground::land_m(graded, p); });
}

double face_m(const SceneHeights& heights, Vec2 p, const ground::FaceHeight& face) {
  return height_m(heights, p, [&](const ground::GradedTerrain& graded) {
    return ground::layer_height_m(ground::heights_at(graded, p), face);
  });
}

}  // namespace citykiln::commands
